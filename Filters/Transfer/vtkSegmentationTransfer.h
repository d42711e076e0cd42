// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSegmentationTransfer
 * @brief   carries the segments of one mesh to another that is like it
 *
 * The skeletons are used as S.-K. Wong, J.-A. Yang, T.-C. Ho, J.-H. Chuang do in "A Skeleton-Based
 * Approach for Consistent Segmentation Transfer" (2012): matched branches are aligned along their
 * length by what the surface is like along both, and turned by the frames of the matched branches. From that
 * follows a dense correspondence: each target vertex is moved to the source's space with its part of the
 * skeleton, drawn to the surface there, and looks up the segments.
 *
 * One energy over the target's faces then settles all boundaries at once: faces want the segment that
 * the dense correspondence finds, boundaries want to be short and to run in concave places, the more
 * so the more the source's own boundaries do. Alpha expansion minimizes it. The result is always a
 * valid labelling: no face is without a segment, and each connected piece of a segment on the source
 * is one connected piece on the target, or absent and reported.
 *
 * With StrictBoundaries, the boundaries go the paper's way: each that encloses one branch is placed
 * on the matching branch of the target, with the places where the thickness changes (ghost boundaries) as
 * landmarks of the alignment, its shape carried by cylindrical parameterizations of the
 * surface round both, and a snake draws it to features of the surface; near it the labels follow it.
 * All others are not carried: the segments beside them become one.
 *
 * Parts of the two skeletons that are matched on neither side but lie in the same place (the backs of
 * two chairs, one with a loop more) are taken for each other by the dense correspondence: each connected part of
 * the target without a partner is carried by the similarity that fits the matched nodes best, those
 * near it counting most, and its nodes stand for the nearest ones of the source without a partner, no
 * further away than 0.15 of the source's bounding box diagonal. They count half as certain as matched
 * ones.
 *
 * Any other segment that lies on branches without a partner is not guessed: its faces join the
 * neighbour and a warning names it. One more answer matches nothing and aligns the meshes as wholes, by their
 * principal axes and closest points. If it fits the surfaces clearly better than all others (a bust, a machine
 * part), or is the only one, it is taken, with a warning. There is none beside answers
 * by slices, nor where the skeletons bring their correspondence.
 *
 * Skeletons say little of surfaces of revolution (a vase, a cup, a shaft), which are told by their outer wall:
 * over three fifths of the directions from an axis, all along it, it is equally far from it, within 5 %.
 * Two of these are cut into slices across their axes, and the chains of slices are aligned by dynamic time
 * warping of radius and slope; handles and spouts, which stand off the wall by a quarter of its radius,
 * correspond among each other. The two ways round are answers before those of the skeletons, whose cost
 * is then 1. If the cheaper costs more than 0.5 (of 1, where nothing agrees), there are none, nor with
 * StrictBoundaries, nor where the skeletons bring their correspondence.
 *
 * Any mesh will do. The method runs on the working surfaces of both meshes (vtkWorkingSurface, of at most
 * vtkMSPSkeleton's MaximumFaces), each body in its canonical frame, and the segments go back to the cells
 * of the input, each and in order. Each body of the target takes its segments from the body of the source
 * that matches it at the least cost. Where a skeleton is connected, which belongs to a mesh as a whole, the
 * mesh is one body. Vertex and line cells get the segment -1.
 *
 * Ports in:
 * - 0, source mesh: polygons; the segments are the cell array "SegmentId" (any integers), or that
 *   set by SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name);
 * - 1, target mesh: polygons;
 * - 2, source skeleton (optional), 3, target skeleton (optional), of vtkMSPSkeleton or the like. A
 *   mesh whose skeleton is connected must have the point array SkeletonNodeId (vtkIdType) of that
 *   skeleton. Without one, it is computed with the defaults of vtkMSPSkeleton;
 * - 4, hints on the source (optional), 5, hints on the target (optional): point sets, as many points on the
 *   one as on the other. Points of equal number are of the same part; or, where the source's point array
 *   Forbidden (any type) is not 0, must not be taken for that. Each stands for the vertex of the mesh that
 *   is nearest.
 *
 * Read from the meshes, and computed with the defaults of vtkMSPField where one of them is missing:
 * point arrays MSP (double, mesh units), MSPGradient (double x 3), DihedralAngle (double, radians); for
 * the skeleton also AGD, MSPCenter and MSPValid. What is found out about a mesh is kept as long as the
 * mesh is the same, so that one filter carries a source to many targets without doing it again.
 * Read from the skeletons: CorrespondenceId (points) and BranchCorrespondenceId (cells) and, if
 * there, BranchCorrespondenceOrder and BranchCorrespondenceReversed (cells); the field array
 * CorrespondenceConfidence (double in [0,1], 1 if absent). If either skeleton lacks the first two,
 * the skeletons are matched as by vtkSkeletonCorrespondence with its defaults, and of its best fourteen
 * leaves the surfaces choose: each is carried out coarsely, by a dense correspondence of some 1000
 * points there and back, and that one is taken for which the sum of four is least: GlobalCost, the mean difference of
 * log MSP between corresponding points (its median aside), how unevenly the other surface is hit (the area by
 * which patches of equal size are hit too often), and how far normals are turned (1 - cosine). The alignment as wholes
 * is one more answer, at 0.1 more than the least GlobalCost.
 *
 * No method is always right, so the user has the last word. Hints come before all other evidence, in the
 * search for answers as in the choice between them: one pair of points on the two heads turns an animal
 * round that was matched back to front. They say which parts correspond, not where boundaries run. Hints
 * that no answer keeps to are warned of.
 *
 * Ports out:
 * - 0, the target mesh, its points, cells and arrays as they were, with the cell arrays
 *   - SegmentId (int): the segment, -1 for none; replaces an array of that name, and is the only active scalars;
 *   - SegmentConfidence (double in [0,1]): the product of MatchingConfidence, of how
 *     far the face lies on matched branches (1; 0.75 on parts that are matched on neither side but were
 *     found in the same place; 0.55 on other branches without a partner) and of the share that the
 *     dense correspondence gives the face's segment, which is small near boundaries;
 *   and the field arrays MatchingCost (double, the cost of the correspondence as vtkSkeletonCorrespondence's
 *   GlobalCost, the mean over the area if there are several bodies; 1 where nothing is matched, 0 where the
 *   skeletons brought their correspondence), MatchingEvidence (double, what the surfaces say
 *   against it; 0 likewise), MatchingConfidence (double in [0,1], how likely it is that the answer brings the right label to
 *   four fifths of the surface or more, calibrated on labelled meshes; CorrespondenceConfidence where the
 *   skeletons brought their correspondence), MatchedBy (string; per body of the target "skeletons",
 *   "slices" or "whole"), and the source's SegmentName (string), if it has one: at i the name of segment i;
 * - 1, the boundaries of the source, 2, those of the target: closed polylines (the first point is
 *   repeated at the end of the cell) with the cell arrays BoundaryId (vtkIdType), FirstSegmentId and
 *   SecondSegmentId (int; the segments on the left and on the right of the line as seen from
 *   outside), EnclosesBranch (unsigned char; 1 if the source's line encloses exactly one branch, and
 *   that is matched). Lines of equal BoundaryId correspond point by point. The source has all of its
 *   closed boundaries, the target those that have a counterpart among its labels, along the edges
 *   between them; with StrictBoundaries the curves of the snake.
 *
 * Errors: a source without the segment array (the message names those there are), or with one of
 * another size, more than one component, values that are no integers, or more than 500 connected
 * pieces of segments (noise); a mesh without a face, or with a point in use that is not finite; a skeleton
 * that is not one, or does not belong to its mesh (SkeletonNodeId is missing or out of range); with
 * KeepTargetSegments a target without that array; hints that are more on one mesh than on the other, or not
 * finite; an AnswerIndex beyond the last answer. The message
 * names the side and says what to do.
 *
 * The field array WorkingSurfaceNote (a string) of the outputs 0 and 1 says what was mended in the target
 * and in the source; it is absent if nothing was.
 *
 * The result is the same, bit for bit, on any number of threads, and however the meshes are placed, turned
 * and scaled and their points and cells numbered.
 *
 * @sa vtkMSPField vtkMSPSkeleton vtkSkeletonCorrespondence
 */
#ifndef vtkSegmentationTransfer_h
#define vtkSegmentationTransfer_h

#include "MarrowTransferModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <set>    // for std::set
#include <vector> // for std::vector

namespace marrow
{
struct SideTransferResult;
}

class MARROWTRANSFER_EXPORT vtkSegmentationTransfer : public vtkPolyDataAlgorithm
{
public:
  static vtkSegmentationTransfer* New();
  vtkTypeMacro(vtkSegmentationTransfer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which answer to how the skeletons match is taken, of each body: 0 is that which the surfaces support
   * best, 1 the next best, and so on. Default 0, range from 0; at most ten are found.
   */
  vtkSetClampMacro(AnswerIndex, int, 0, VTK_INT_MAX);
  vtkGetMacro(AnswerIndex, int);
  ///@}

  ///@{
  /**
   * The segments to carry; all others stay away, and their cells get -1, no segment. Default: all are
   * carried, as long as none is added.
   */
  void AddCarriedSegment(int segment);
  void RemoveAllCarriedSegments();
  ///@}

  ///@{
  /**
   * Whether the segments that the target has already are kept: its cell array "SegmentId", where that is
   * not -1 (vtkMarrowSegmentSelector makes one of another). The segments that are carried to the other
   * cells then meet them. Default off.
   */
  vtkSetMacro(KeepTargetSegments, bool);
  vtkGetMacro(KeepTargetSegments, bool);
  vtkBooleanMacro(KeepTargetSegments, bool);
  ///@}

  ///@{
  /**
   * Only the boundaries of the paper, and its way to carry them: those that enclose exactly one branch
   * are transferred one by one, by cylindrical parameterization and snake; all
   * others are dropped, and the smaller segments beside them join the largest. Default off.
   */
  vtkSetMacro(StrictBoundaries, bool);
  vtkGetMacro(StrictBoundaries, bool);
  vtkBooleanMacro(StrictBoundaries, bool);
  ///@}

  ///@{
  /**
   * With StrictBoundaries, how far a maximum of the profile of MSP's gradient along a branch must stand out to
   * count as a ghost boundary: its ratio to the higher of the lowest values on both its sides (the paper's θ).
   * Default 1.5, range 1 to 100.
   */
  vtkSetClampMacro(Theta, double, 1.0, 100.0);
  vtkGetMacro(Theta, double);
  ///@}

  ///@{
  /**
   * With StrictBoundaries, the standard deviation of the Gaussian that smoothes that profile, as a fraction of the branch's
   * length (the paper's K). Default 0.05, range 0.005 to 0.5.
   */
  vtkSetClampMacro(Kernel, double, 0.005, 0.5);
  vtkGetMacro(Kernel, double);
  ///@}

  ///@{
  /**
   * With StrictBoundaries, the snake takes vertices for the same feature whose dihedral angles differ by less than this
   * (the paper's λ), in radians. Default 0.1, range 0 to π.
   */
  vtkSetClampMacro(Lambda, double, 0.0, 3.14159265358979);
  vtkGetMacro(Lambda, double);
  ///@}

  ///@{
  /**
   * With StrictBoundaries, how far a point of a boundary may be moved by the snake, as a fraction of the longest geodesic
   * distance on the target. 0 lets it stay on the nearest edge. Default 0.02, range 0 to 0.2.
   */
  vtkSetClampMacro(SearchRegion, double, 0.0, 0.2);
  vtkGetMacro(SearchRegion, double);
  ///@}

  ///@{
  /**
   * Takes a skeleton that was given (ports 2 and 3) away again, so that it is computed, or the hints
   * (ports 4 and 5). The same as
   * SetInputConnection(port, nullptr), which ParaView cannot call.
   */
  void RemoveSourceSkeleton() { this->SetInputConnection(2, nullptr); }
  void RemoveTargetSkeleton() { this->SetInputConnection(3, nullptr); }
  void RemoveSourceHints() { this->SetInputConnection(4, nullptr); }
  void RemoveTargetHints() { this->SetInputConnection(5, nullptr); }
  ///@}

protected:
  vtkSegmentationTransfer();
  ~vtkSegmentationTransfer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSegmentationTransfer(const vtkSegmentationTransfer&) = delete;
  void operator=(const vtkSegmentationTransfer&) = delete;

  /// Cells of segments that are not to be carried get none, unless they keep their own.
  void DropWhatIsNotCarried(
    const std::vector<int>& keptLabels, marrow::SideTransferResult& result) const;

  int AnswerIndex = 0;
  std::set<int> CarriedSegments; ///< empty: all
  bool KeepTargetSegments = false;
  bool StrictBoundaries = false;
  double Theta = 1.5;
  double Kernel = 0.05;
  double Lambda = 0.1;
  double SearchRegion = 0.02;

  struct Analysis;
  std::unique_ptr<Analysis> Analyzed;
};

#endif
