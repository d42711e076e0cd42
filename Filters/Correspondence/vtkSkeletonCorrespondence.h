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
 * Going beyond the paper, the leaves are compared by a cost over the whole skeletons
 * (GlobalSelection): for all matched terminals, the paths between them by length and by MSP along
 * them, how MSP grows from the tip inwards, twins (two legs go to two legs), how they lie in space,
 * what would have to be merged and what is left over; and handedness, which tells left from right
 * where all else is equal. The best leaves are refined by exchanging terminals; a beam search over the terminals
 * adds at most four that are unlike all of these, in a quarter of the source's terminals by weight; and the branches
 * follow from the terminals: those that split the terminals alike are the same. What the searches find are
 * leaves of their own. The pose matters little; the numbering of points, position, orientation and
 * size do not matter.
 *
 * A limb that touches another and was modelled as one with it (a hand on a thigh) is a loop that the
 * other skeleton may not have. With the correspondence tree and GlobalSelection, the skeleton with
 * more loops is therefore also tried with one opened: a branch on a loop is taken off a junction of
 * three branches, ends in a tip there, and the two others are one branch. The best such opening is kept
 * if it brings the lowest GlobalCost to less than 0.9 of what it was, and the next loop is tried, until
 * both skeletons have equally many loops or four are opened. The outputs are always the skeletons as
 * they were given: the junction that the branch was taken off has the CorrespondenceId of the tip, and
 * the two others are a chain. Statistics and leaves are those of the opening that was kept. With
 * electors voting, or with GlobalSelection off, no loop is opened.
 *
 * Skeletons without a junction (a snake, a capsule) are matched along the path between their
 * terminals in the direction in which MSP and AGD run alike; rings without a junction (a torus) by
 * the ring. Several components are matched largest with most alike, each component once, and not
 * refined.
 *
 * The other matcher, to compare with, is electors voting: O. K.-C. Au, C.-L. Tai, D. Cohen-Or, Y.
 * Zheng, H. Fu, "Electors voting for fast automatic shape correspondence", Computer Graphics Forum
 * 29(2), 2010. A search over the terminals and junctions, one to one, prunes every set of pairs that
 * fails a test of centricity (CentricityTolerance), path lengths (PathTolerance), topology (which
 * nodes lie between which) or spatial configuration (SpatialTolerance; no reflection). Each set that
 * survives votes for its pairs, and the pairs of most votes that pass the tests together win; branches
 * follow from their ends. It merges no junctions and leaves more unmatched. The search keeps 1000 sets
 * at a time, looks at 48 nodes of a skeleton at most, those of the longest branches, and relaxes the
 * first two tolerances where less than half of the nodes would be matched. The thresholds
 * and these limits are ours.
 *
 * Limits: a horn goes to an ear, or a head without a muzzle to an ear, where the target has nothing
 * better; of rotational symmetries (an octopus) any rotation may come out; left and right of bodies
 * whose skeletons are flat are a guess; loops are opened on one side only, and not where limbs have
 * grown together at a junction of more than three branches.
 *
 * Input port 0: the source, a skeleton (vtkPolyData) of vtkMSPSkeleton or vtkMarrowMeanCurvatureSkeleton.
 * Input port 1: the target, another one.
 *
 * | array read | on | type | meaning |
 * | --- | --- | --- | --- |
 * | AGD, MSP, Radius | points | one component | as vtkMSPSkeleton gives them |
 * | MeshDiagonal, MeshMaximumMSP | field | one value | if absent, the skeleton's own stand in |
 *
 * Output ports 0 and 1: source and target, all of their arrays kept, and the following.
 *
 * | array | on | type | meaning |
 * | --- | --- | --- | --- |
 * | CorrespondenceId | points | vtkIdType | equal on both: the same part; -1: none |
 * | BranchCorrespondenceId | cells | vtkIdType | equal on both: the same part; -1: none |
 * | BranchCorrespondenceOrder | cells | vtkIdType | place in its chain, from 0; -1: none |
 * | BranchCorrespondenceReversed | cells | unsigned char | 1: runs against its chain |
 * | CorrespondenceTreeNodes | field | vtkIdType | nodes of the tree that were kept |
 * | CorrespondenceTreeHeight | field | vtkIdType | steps from the root to the lowest leaf |
 * | CorrespondenceCorePairs | field | vtkIdType | pairs of junctions the tree begins with |
 * | CorrespondenceMerges | field | vtkIdType | mergings of junctions and branches, in all nodes |
 * | CorrespondenceClusters | field | vtkIdType | clusters of branches found, in all nodes |
 * | CorrespondenceLeaves | field | vtkIdType | leaves of the tree, some may say the same |
 * | CorrespondenceConfidence | field | double | in [0,1], see below |
 *
 * Only terminals and junctions have a CorrespondenceId. Several points of one skeleton with one id
 * are a merged group, several polylines with one BranchCorrespondenceId a chain of merged
 * branches; polylines inside a merged group have -1. A chain runs on both skeletons from the same
 * CorrespondenceId to the same CorrespondenceId, also where the two are equal (a loop): walk its
 * polylines in their order, backwards where reversed. The fields up to the leaves are the numbers
 * of the paper's Table 3; with electors voting, they are the sets kept, the nodes searched, the pairs
 * alike in centricity, the junctions that matched chains pass, 0, and the electors. The confidence is
 * the share of terminals that may be expected to be matched with the same part, judged by GlobalCost
 * as fitted to labelled meshes.
 *
 * Input ports 2 and 3 (optional): hints on the source and on the target, point sets with as many points on
 * the one as on the other, on the skeletons or the surfaces of the meshes. Points of equal number are of the
 * same part; or, where the source's point array Forbidden (any type) is not 0, must not be taken for that.
 * The leaves that keep to them come first; with the correspondence tree and GlobalSelection, such leaves
 * are also searched for. GlobalCost and the confidence know nothing of hints.
 *
 * Output port 2: vtkTable, one row per leaf, the best first, of leaves that match the same only the
 * best; row i is what LeafIndex i puts out. Electors voting has one row, the winner. Columns GlobalCost,
 * PaperCost (the paper's equation 7), Confidence, SourceCoverage, TargetCoverage (double; matched
 * length over the skeleton's), Refined (unsigned char; 1 if not of the tree), JunctionPairs,
 * TerminalPairs, BranchPairs, Merges (vtkIdType).
 *
 * Errors: a skeleton that is empty, lacks an array, has values that are not finite or lines that
 * run through junctions; LeafIndex beyond the last leaf; hints that are more on one side than on the other,
 * or not finite.
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

  /**
   * The methods, see above.
   */
  enum Matchers
  {
    CORRESPONDENCE_TREE = 0,
    ELECTORS_VOTING = 1
  };

  ///@{
  /**
   * The method. Default CORRESPONDENCE_TREE; ELECTORS_VOTING is there to compare with, see above.
   */
  vtkSetClampMacro(Matcher, int, CORRESPONDENCE_TREE, ELECTORS_VOTING);
  vtkGetMacro(Matcher, int);
  void SetMatcherToCorrespondenceTree() { this->SetMatcher(CORRESPONDENCE_TREE); }
  void SetMatcherToElectorsVoting() { this->SetMatcher(ELECTORS_VOTING); }
  ///@}

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

  ///@{
  /**
   * Electors voting: nodes whose AGD differs by more than this do not match. Default 0.4, range
   * [0, 1].
   */
  vtkSetClampMacro(CentricityTolerance, double, 0.0, 1.0);
  vtkGetMacro(CentricityTolerance, double);
  ///@}

  ///@{
  /**
   * Electors voting: two nodes do not match two others if the paths between them differ in length by
   * more than this; a fraction of each skeleton's longest path. Default 0.3, range [0, 1].
   */
  vtkSetClampMacro(PathTolerance, double, 0.0, 1.0);
  vtkGetMacro(PathTolerance, double);
  ///@}

  ///@{
  /**
   * Electors voting: nodes do not match together if more than this share of their spread remains after
   * the best rotation and scale. Default 0.35, range [0, 2].
   */
  vtkSetClampMacro(SpatialTolerance, double, 0.0, 2.0);
  vtkGetMacro(SpatialTolerance, double);
  ///@}

  ///@{
  /**
   * Takes hints (ports 2 and 3) away again. The same as SetInputConnection(port, nullptr), which ParaView
   * cannot call.
   */
  void RemoveSourceHints() { this->SetInputConnection(2, nullptr); }
  void RemoveTargetHints() { this->SetInputConnection(3, nullptr); }
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

  int Matcher = CORRESPONDENCE_TREE;
  int LeafIndex = 0;
  bool GlobalSelection = true;
  double JunctionThreshold = 0.02;
  double MergeDistance = 0.075;
  double ClusterDistance = 0.1;
  int DescriptorPieces = 8;
  double CentricityTolerance = 0.4;
  double PathTolerance = 0.3;
  double SpatialTolerance = 0.35;
};

#endif
