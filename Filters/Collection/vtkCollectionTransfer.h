// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCollectionTransfer
 * @brief   labels all meshes of a collection from those that are labelled
 *
 * One labelled mesh and a folder of others of its kind, or a few labelled ones: the labels spread from all
 * meshes to all others, so that the others correct what one pair gets wrong.
 *
 * Each mesh is made ready once, as by vtkSegmentationTransfer: its working surface, measures and skeleton.
 * Then the skeletons are matched: all pairs of up to 24 meshes; of more, each mesh is matched with its eight
 * nearest by a sketch of the skeleton (its loops, its terminals, lengths and radii of its limbs), with its
 * eight nearest labelled ones, and along a spanning tree, so that time grows with the number of meshes and
 * not with its square. A pair is matched once for both ways, and its ten best answers are carried out coarsely
 * both ways, as vtkSegmentationTransfer does one way.
 *
 * The labels spread: every mesh without labels hears from the labelled ones it is matched with, then also
 * from the others, in two rounds. A teller counts exp(-6 e) for e = all that speaks against the answer (the
 * cost of the matching, differing thickness, uneven cover, turned normals), half of that where the meshes are aligned as
 * wholes, and twice that if it is labelled; after each round the shares of the labels are raised to the power of 1.5. At first this is done
 * coarsely, and every pair's answer is chosen anew, twice: that one against which least is to be said, what
 * it carries differing from what all others say being one thing more. With the answers so chosen the labels
 * spread once more at the resolution of the working surfaces, from all labelled meshes and the eight others
 * that count most, and one cut for each mesh settles where the boundaries run: where the shares leave it
 * open, in concave places, the more so the more the labelled meshes' own boundaries do.
 *
 * With three labelled meshes or more, LearnFromSources also learns from them: a forest of decision trees,
 * which knows only them and is forgotten afterwards, tells labels by the measures of the surface (AGD, MSP and
 * its gradient, the dihedral angle, the place along the branch, curvature and extent at several scales) and by
 * what the vote says. The labels of each of them, of at most eight, are held back in turn, and the power of the
 * learnt probabilities by which the shares are multiplied is the one that makes the vote on those most
 * accurate, beyond chance and to the harm of none of them; often none does. Where the vote gets less than 0.8 of one
 * of them right, they are too unlike one another to learn from.
 *
 * Equal numbers are equal segments on all labelled meshes. What was found out about meshes and pairs is
 * kept as long as they are the same: if labels are added or corrected, only what depends on labels is
 * computed anew. With CacheFolder it is also kept in files.
 *
 * Port in, 0: a vtkMultiBlockDataSet or any other tree of datasets. Each leaf is a vtkPolyData: any mesh
 * will do. A leaf with the cell array "SegmentId" (any integers), or that set by
 * SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name), is labelled.
 *
 * Ports out:
 * - 0, the same tree: the meshes with their points, cells and arrays, and the cell arrays
 *   - SegmentId (int): the segment, on a labelled mesh as it was; the only active scalars;
 *   - SegmentConfidence (double in [0,1]): the share that all tellers together give the face's segment,
 *     smaller near boundaries, times how far the best way from a labelled mesh is to be trusted; 1 on
 *     a labelled mesh;
 *   - RejectedSegmentId (int, a component for each), if NumberOfRejectedAnswers is not 0 and there are such answers,
 *     on a mesh that was not labelled: the segments by the answers that would have come next, as coarse as
 *     they were tried out, those first that come nearest to being taken. The field arrays RejectedAgainst
 *     (double, a value for each) is what speaks against them, as Against below, and RejectedDifference (double)
 *     the share of the area that they would label otherwise;
 *   and the field array SegmentName of the first labelled mesh that has it. What cannot be used (see the
 *   warnings) goes through as it is;
 * - 1, a vtkTable with a row for each leaf in their order: Block (string, its name; "block 3" without one),
 *   IsSource (unsigned char, 1 where it was labelled), Source (string, the labelled mesh that counts most
 *   for it), Confidence (double, mean of SegmentConfidence over the area), Against (double, what speaks
 *   against the answer taken of that source, 0 to 5, good ones below 1), Learning (double, the power of the
 *   learnt probabilities by which the vote was multiplied; 0: nothing was learnt), HeldOutAccuracy and
 *   HeldOutAccuracyLearnt (double, of a labelled mesh whose labels were held back the share of its area that the
 *   vote alone, and with what was learnt from the others, labels as they do; not a number for all others), Note
 *   (string, what was mended and what went wrong).
 *
 * Errors: no leaf that can be used is labelled; more than 500 different segments; a Controller of several
 * processes without a CacheFolder.
 * Warnings, each of which names the leaf: one that is no vtkPolyData, has no face, points that are not
 * finite, or a segment array that is not one integer a cell; meshes that are aligned as wholes with all
 * labelled ones.
 *
 * The result is the same on any number of threads, in whatever order the leaves come, and however each of
 * them is placed, turned, scaled and numbered.
 *
 * @sa vtkSegmentationTransfer vtkSegmentationFusion
 */
#ifndef vtkCollectionTransfer_h
#define vtkCollectionTransfer_h

#include "MarrowCollectionModule.h" // for export macro
#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h" // for the controller

#include <functional> // for progress
#include <memory>     // for std::unique_ptr
#include <string>     // for the warnings
#include <vector>     // for the leaves

class vtkDataObjectTree;
class vtkMultiProcessController;
namespace marrow
{
struct CollectionLeaf;
}

class MARROWCOLLECTION_EXPORT vtkCollectionTransfer : public vtkDataObjectAlgorithm
{
public:
  static vtkCollectionTransfer* New();
  vtkTypeMacro(vtkCollectionTransfer, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A folder, which must be there, in which what is found out about each pair of meshes is kept, in a file
   * named by the contents of both: another run takes it from there, one that was stopped goes on. Files
   * that are damaged or cannot be written are as good as none. Default none: only the filter itself
   * remembers.
   */
  vtkSetFilePathMacro(CacheFolder);
  vtkGetFilePathMacro(CacheFolder);
  ///@}

  ///@{
  /**
   * The processes that share the work, if there are several; none by default. All have the same input and the
   * same CacheFolder, which has to be set, and by whose files they tell each other of pairs: on several
   * machines a folder on a file system that these share. The output is with the first process, on the others
   * the tree is empty. It is the same as that of one process. The first process holds all meshes, the others
   * a few dozen at a time.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  ///@{
  /**
   * How many of the answers that were not taken are given out, to be looked at: of those of the labelled
   * mesh that counts most, each of which would label 5 % of the area or more otherwise. Default 0, range
   * [0, 9].
   */
  vtkSetClampMacro(NumberOfRejectedAnswers, int, 0, 9);
  vtkGetMacro(NumberOfRejectedAnswers, int);
  ///@}

  ///@{
  /**
   * Whether to learn from the labelled meshes, where there are three or more: it takes some seconds, and the maps
   * between the labelled meshes. Default on. Without dlib (CanLearn) nothing is learnt.
   */
  vtkSetMacro(LearnFromSources, bool);
  vtkGetMacro(LearnFromSources, bool);
  vtkBooleanMacro(LearnFromSources, bool);
  ///@}

  /**
   * Whether Marrow was built with dlib, which learning needs.
   */
  static bool CanLearn();

protected:
  vtkCollectionTransfer();
  ~vtkCollectionTransfer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkCollectionTransfer(const vtkCollectionTransfer&) = delete;
  void operator=(const vtkCollectionTransfer&) = delete;

  /// The warning, which the leaf's note has too.
  void Warn(marrow::CollectionLeaf& leaf, const std::string& warning);
  /// What cannot be used is a mesh no more.
  void ReadLabels(std::vector<marrow::CollectionLeaf>& leaves);
  /// False if `progress` asked to stop.
  bool CollectMeshes(const std::vector<int>& leafOfMesh,
    std::vector<marrow::CollectionLeaf>& leaves, const std::function<bool(double)>& progress);
  void WriteLeaves(std::vector<marrow::CollectionLeaf>& leaves, vtkDataObjectTree* input,
    vtkDataObjectTree* output);

  char* CacheFolder = nullptr;
  int NumberOfRejectedAnswers = 0;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  bool LearnFromSources = true;

  struct Memory;
  std::unique_ptr<Memory> Remembered;
};

#endif
