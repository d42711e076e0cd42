// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkeletonCorrespondence
 * @brief   Which branches and nodes of two skeletons are the same parts
 *
 * Matches the junctions, terminals and branches of two skeletons, many to many: where one skeleton
 * has two junctions and the other one, the two are merged into a group; where one has a spur, the
 * branches before and behind it are merged into a chain.
 *
 * The method is the correspondence tree of S.-K. Wong, J.-A. Yang, T.-C. Ho, J.-H. Chuang, "A
 * Skeleton-Based Approach for Shape Correspondence" (2012), sections 3 and 4: the junctions that
 * are most alike in centricity and in the sizes of their sub-skeletons are matched first, then, by
 * turns, the branches of matched junctions (by shape matching of their directions, without
 * reflections) and the junctions at the far ends of matched branches. Every choice is a node of a
 * tree; every leaf of it is a complete answer with a cost.
 *
 * Skeletons without a junction (a snake, a capsule) are matched along the path between their
 * terminals in the direction in which MSP and AGD run alike; rings without a junction (a torus) by
 * the ring. Several components are matched largest with most alike, each component once.
 *
 * Ports in:
 * - 0, source: a skeleton (vtkPolyData) of vtkMSPSkeleton or vtkMeanCurvatureSkeleton;
 * - 1, target: another one.
 *
 * Arrays read from both: point arrays AGD, MSP, Radius (double, one component); field arrays
 * MeshDiagonal, MeshMaximumMSP (if absent, those of the skeleton itself stand in).
 *
 * Ports out:
 * - 0, 1: the skeletons, all of their arrays kept, with
 *   - CorrespondenceId (points, vtkIdType): equal on both = matched; several points of one skeleton
 *     with the same id are a merged group; -1 for nodes without a partner and for all regular
 * nodes;
 *   - BranchCorrespondenceId (cells, vtkIdType): equal on both = matched; several polylines of one
 *     skeleton with the same id are a chain of merged branches; -1 for branches without a partner
 * and for those inside a merged group;
 *   - BranchCorrespondenceOrder (cells, vtkIdType): the place of the polyline in its chain, from 0;
 * -1 if unmatched;
 *   - BranchCorrespondenceReversed (cells, unsigned char): 1 if the polyline runs against the
 * chain. A matched pair of chains runs on both skeletons from the same CorrespondenceId to the same
 *     CorrespondenceId, also where the two are equal (a loop);
 *   and the field arrays, one value each: CorrespondenceTreeNodes, CorrespondenceTreeHeight,
 *   CorrespondenceCorePairs, CorrespondenceMerges, CorrespondenceClusters, CorrespondenceLeaves
 *   (vtkIdType; the numbers of the paper's Table 3) and CorrespondenceConfidence (double in [0,1]).
 * - 2: vtkTable, one row per leaf, the best first; row i is what LeafIndex i puts out. Columns
 *   GlobalCost, PaperCost, Confidence, SourceCoverage, TargetCoverage (double; matched length over the
 *   skeleton's length), Refined (unsigned char; 1 if the leaf is not of the tree but was found by
 *   going on from one), JunctionPairs, TerminalPairs, BranchPairs, Merges (vtkIdType).
 *
 * Errors: a skeleton that is empty, lacks an array, has values that are not finite or lines that
 * run through junctions; LeafIndex beyond the last leaf.
 */
#ifndef vtkSkeletonCorrespondence_h
#define vtkSkeletonCorrespondence_h

#include "MarrowCorrespondenceModule.h" // for export macro
#include "vtkDataObjectAlgorithm.h"

class MARROWCORRESPONDENCE_EXPORT vtkSkeletonCorrespondence : public vtkDataObjectAlgorithm
{
public:
  static vtkSkeletonCorrespondence* New();
  vtkTypeMacro(vtkSkeletonCorrespondence, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which leaf to put out, 0 being the best. Default 0.
   */
  vtkSetClampMacro(LeafIndex, int, 0, VTK_INT_MAX);
  vtkGetMacro(LeafIndex, int);
  ///@}

  ///@{
  /**
   * Whether the leaf is chosen by a cost over the whole skeletons, which goes beyond the paper, or
   * by the paper's product of the costs at the junctions. Default on.
   */
  vtkSetMacro(GlobalSelection, bool);
  vtkGetMacro(GlobalSelection, bool);
  vtkBooleanMacro(GlobalSelection, bool);
  ///@}

  ///@{
  /**
   * Two junctions match at once if their cost is at most this (the paper's C_J, 0.012 to 0.025);
   * else merging is tried, and where nothing passes, the threshold relaxes. Default 0.02, range
   * [0, 1].
   */
  vtkSetClampMacro(JunctionThreshold, double, 0.0, 1.0);
  vtkGetMacro(JunctionThreshold, double);
  ///@}

  ///@{
  /**
   * Junctions no further apart along the skeleton than this may be merged; a fraction of the mesh's
   * bounding box diagonal (the paper's d_J, 0.05 to 0.1). Default 0.075, range [0, 1].
   */
  vtkSetClampMacro(MergeDistance, double, 0.0, 1.0);
  vtkGetMacro(MergeDistance, double);
  ///@}

  ///@{
  /**
   * Branches of a junction whose MSP descriptors differ by at most this are a cluster (the paper's
   * λ_B). Default 0.1, range [0, 10].
   */
  vtkSetClampMacro(ClusterDistance, double, 0.0, 10.0);
  vtkGetMacro(ClusterDistance, double);
  ///@}

  ///@{
  /**
   * Number of pieces of a branch's MSP descriptor (the paper's K). Default 8, range [1, 256].
   */
  vtkSetClampMacro(DescriptorPieces, int, 1, 256);
  vtkGetMacro(DescriptorPieces, int);
  ///@}

protected:
  vtkSkeletonCorrespondence();
  ~vtkSkeletonCorrespondence() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSkeletonCorrespondence(const vtkSkeletonCorrespondence&) = delete;
  void operator=(const vtkSkeletonCorrespondence&) = delete;

  int LeafIndex = 0;
  bool GlobalSelection = true;
  double JunctionThreshold = 0.02;
  double MergeDistance = 0.075;
  double ClusterDistance = 0.1;
  int DescriptorPieces = 8;
};

#endif
