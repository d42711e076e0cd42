// SPDX-License-Identifier: BSD-3-Clause
// The other matcher of vtkSkeletonCorrespondence.
#include "MatchedShapes.h"

#include "ElectorsVoting.h"
#include "ErrorObserver.h"
#include "vtkCreatureSource.h"
#include "vtkMSPSkeleton.h"

#include <vtkIdList.h>

#include <gtest/gtest.h>

#include <map>

using namespace marrow::test;

namespace
{
Matched Vote(const SkeletonShape& source, const SkeletonShape& target, unsigned seed = 0)
{
  return { source, target, seed, 0, Matched::Selection::Electors };
}

/// One to one: no id is on two points of a skeleton.
void ExpectNoGroups(const Matched& matched)
{
  for (int side = 0; side < 2; ++side)
  {
    std::set<double> seen;
    vtkDataArray* ids = matched.Output(side)->GetPointData()->GetArray("CorrespondenceId");
    for (vtkIdType p = 0; p < ids->GetNumberOfTuples(); ++p)
    {
      const double id = ids->GetTuple1(p);
      EXPECT_TRUE(id < 0.0 || seen.insert(id).second) << id;
    }
  }
}

/// The skeleton of a creature, and for each of its points the segment of the mesh round it.
struct Creature
{
  Creature(int shape, double pose, unsigned seed)
  {
    vtkNew<vtkCreatureSource> source;
    source->SetShape(shape);
    source->SetResolution(2500);
    source->SetPose(pose);
    source->SetSeed(seed);
    this->Filter->SetInputConnection(source->GetOutputPort());
    this->Filter->Update();
    auto* mesh = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
    vtkDataArray* nodes = mesh->GetPointData()->GetArray("SkeletonNodeId");
    vtkDataArray* segments = mesh->GetCellData()->GetArray("SegmentId");
    std::map<int, std::map<int, int>> counts;
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, points);
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        ++counts[static_cast<int>(nodes->GetTuple1(points->GetId(i)))]
                [static_cast<int>(segments->GetTuple1(cell))];
      }
    }
    for (const auto& [node, ofSegment] : counts)
    {
      this->SegmentOfNode[node] = std::max_element(ofSegment.begin(), ofSegment.end(),
        [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first;
    }
  }
  vtkNew<vtkMSPSkeleton> Filter;
  std::map<int, int> SegmentOfNode;
};

/// The segments of matched terminals, source to target.
std::map<int, int> MatchedSegments(const Creature& source, const Creature& target)
{
  vtkNew<vtkSkeletonCorrespondence> filter;
  filter->SetMatcherToElectorsVoting();
  filter->SetInputConnection(0, source.Filter->GetOutputPort(0));
  filter->SetInputConnection(1, target.Filter->GetOutputPort(0));
  filter->Update();
  std::map<int, int> segmentOfId[2];
  for (int side = 0; side < 2; ++side)
  {
    vtkPointData* data =
      vtkPolyData::SafeDownCast(filter->GetOutputDataObject(side))->GetPointData();
    vtkDataArray* ids = data->GetArray("CorrespondenceId");
    for (vtkIdType p = 0; p < ids->GetNumberOfTuples(); ++p)
    {
      constexpr double terminal = 1.0;
      if (ids->GetTuple1(p) >= 0.0 && data->GetArray("NodeType")->GetTuple1(p) == terminal)
      {
        segmentOfId[side][static_cast<int>(ids->GetTuple1(p))] =
          (side == 0 ? source : target).SegmentOfNode.at(static_cast<int>(p));
      }
    }
  }
  std::map<int, int> result;
  for (const auto& [id, segment] : segmentOfId[0])
  {
    result[segment] = segmentOfId[1].at(id);
  }
  return result;
}
}

TEST(ElectorsVoting, MatchesASkeletonWithItself)
{
  const Matched matched = Vote(MakeQuadruped(), MakeQuadruped());
  matched.ExpectSame(QuadrupedTerminals());
  matched.ExpectSame({ "chest", "hip" });
  EXPECT_GE(matched.BranchId(0, "hip", "chest"), 0);
  EXPECT_EQ(matched.BranchId(0, "hip", "chest"), matched.BranchId(1, "hip", "chest"));
  EXPECT_EQ(7, matched.Table()->GetValueByName(0, "BranchPairs").ToInt());
  EXPECT_NEAR(1.0, matched.Table()->GetValueByName(0, "TargetCoverage").ToDouble(), 1e-12);
  EXPECT_GT(matched.Field("CorrespondenceConfidence"), 0.5);
  ExpectNoGroups(matched);
}

TEST(ElectorsVoting, FollowsRotationScaleAndPose)
{
  SkeletonShape target = MakeQuadruped();
  target.Move("fore left", 0.3, 0.1, 0.05);
  target.Move("hind right", -0.3, 0.1, 0.0);
  target.Move("head", -0.1, -0.5, 0.1);
  target.Transform(
    7.5 * Eigen::AngleAxisd(2.1, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix());
  const Matched matched = Vote(MakeQuadruped(), target);
  matched.ExpectSame(QuadrupedTerminals());
  matched.ExpectSame({ "chest", "hip" });
}

TEST(ElectorsVoting, TurnsLeftToRightInAMirrorImage)
{
  SkeletonShape target = MakeQuadruped();
  target.Transform(Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal());
  const Matched matched = Vote(MakeQuadruped(), target);
  matched.ExpectSame({ "head", "tail" });
  EXPECT_EQ(matched.NodeId(0, "fore left"), matched.NodeId(1, "fore right"));
  EXPECT_EQ(matched.NodeId(0, "hind right"), matched.NodeId(1, "hind left"));
}

TEST(ElectorsVoting, MatchesCreaturesOfAnotherPose)
{
  const std::map<int, int> quadruped = MatchedSegments(
    Creature(vtkCreatureSource::QUADRUPED, 0.0, 1), Creature(vtkCreatureSource::QUADRUPED, 0.3, 3));
  EXPECT_EQ(6u, quadruped.size());
  for (const auto& [source, target] : quadruped)
  {
    EXPECT_EQ(source, target);
  }
  // A biped is so flat that left and right are a guess, for arms and legs apart.
  const std::map<int, int> biped = MatchedSegments(
    Creature(vtkCreatureSource::BIPED, 0.0, 1), Creature(vtkCreatureSource::BIPED, 0.3, 3));
  EXPECT_EQ(5u, biped.size());
  const auto kindOf = [](int segment) { return (segment + 1) / 2; };
  for (const auto& [source, target] : biped)
  {
    EXPECT_EQ(kindOf(source), kindOf(target)) << source << " to " << target;
  }
}

TEST(ElectorsVoting, LeavesAnEarWithoutPartnerAndPassesItsJunction)
{
  SkeletonShape target = MakeQuadruped();
  target.Point("ear", 1.5, 1.75, 0.12, 0.03);
  target.Line({ "neck", "ear" });
  const Matched matched = Vote(MakeQuadruped(), target);
  ExpectPassed(matched, "ear");
}

TEST(ElectorsVoting, MatchesSkeletonsWithoutJunctions)
{
  const Matched snakes = Vote(MakeSnake(0.3), MakeSnake(0.6), 3);
  snakes.ExpectSame({ "head", "tail" });
  EXPECT_EQ(0, snakes.BranchId(0, "head", "tail"));
  EXPECT_EQ(0, snakes.BranchId(1, "head", "tail"));

  SkeletonShape ring = MakeRing();
  ring.Transform(Eigen::Vector3d(2.0, 1.8, 2.0).asDiagonal());
  const Matched rings = Vote(MakeRing(), ring);
  EXPECT_EQ(0, rings.BranchId(0, "ring a", "ring b"));
  EXPECT_EQ(0, rings.BranchId(1, "ring a", "ring b"));
  // A ring is no snake: nothing is matched, and the answer is not trusted.
  const Matched neither = Vote(MakeRing(), MakeSnake(0.3));
  EXPECT_EQ(0, neither.Table()->GetValueByName(0, "BranchPairs").ToInt());
  EXPECT_EQ(0.0, neither.Field("CorrespondenceConfidence"));
}

TEST(ElectorsVoting, ClosesLoops)
{
  SkeletonShape target = MakeChair();
  target.Transform(Eigen::Vector3d(0.9, 1.1, 0.95).asDiagonal());
  const Matched matched = Vote(MakeChair(), target);
  // The legs are alike but for the back above them, which no test looks at.
  matched.ExpectSame({ "seat" });
  EXPECT_EQ(4, matched.Table()->GetValueByName(0, "TerminalPairs").ToInt());
  const int id = matched.BranchId(0, "rail left", "rail right");
  EXPECT_GE(id, 0);
  EXPECT_EQ(id, matched.BranchId(1, "rail left", "rail right"));
}

TEST(ElectorsVoting, KeepsComponentsApart)
{
  const SkeletonShape both = MakeQuadrupedAndStick();
  SkeletonShape target = both;
  target.Transform(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY()).toRotationMatrix());
  const Matched matched = Vote(both, target);
  matched.ExpectSame(QuadrupedTerminals());
  matched.ExpectSame({ "stick top", "stick end" });
}

TEST(ElectorsVoting, IsConsistentOnAnythingAndMergesNoNodes)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const Matched matched = Vote(MakeRandomShape(seed), MakeRandomShape(1000 + seed * 7));
    ExpectConsistent(matched);
    ExpectNoGroups(matched);
  }
}

TEST(ElectorsVoting, DoesNotDependOnTheNumberingOfNodes)
{
  SkeletonShape target = MakeQuadruped();
  target.Move("tail", 0.1, 0.7, -0.2);
  const Matched reference = Vote(MakeQuadruped(), target);
  for (unsigned seed = 1; seed < 6; ++seed)
  {
    const Matched matched = Vote(MakeQuadruped(), target, seed);
    for (const std::string& name : QuadrupedTerminals())
    {
      for (const std::string& other : QuadrupedTerminals())
      {
        EXPECT_EQ(reference.NodeId(0, name) == reference.NodeId(1, other),
          matched.NodeId(0, name) == matched.NodeId(1, other))
          << name << " and " << other;
      }
    }
  }
}

TEST(ElectorsVoting, IsBoundedWhereAllIsAlike)
{
  // More terminals than the search takes, each like any other: every level has more sets than it may keep.
  const Matched matched = Vote(MakeStar(60), MakeStar(60));
  const marrow::FeaturePaths paths(marrow::FeatureGraph(MakeStar(60).Build(), 8));
  EXPECT_EQ(marrow::FeaturePaths::MaximumFeatures, paths.Size());
  EXPECT_EQ(marrow::FeaturePaths::MaximumFeatures, matched.Field("CorrespondenceTreeHeight"));
  EXPECT_EQ(marrow::ElectorsVoting::MaximumSets, matched.Field("CorrespondenceLeaves"));
  EXPECT_LE(matched.Field("CorrespondenceTreeNodes"),
    marrow::ElectorsVoting::MaximumSets * marrow::FeaturePaths::MaximumFeatures);
}

TEST(ElectorsVoting, ReportsTheElectorsAndStopsWhenAsked)
{
  const Matched matched = Vote(MakeQuadruped(), MakeQuadruped());
  EXPECT_EQ(8.0, matched.Field("CorrespondenceTreeHeight"));
  EXPECT_GE(matched.Field("CorrespondenceLeaves"), 2.0);
  EXPECT_GT(matched.Field("CorrespondenceTreeNodes"), matched.Field("CorrespondenceLeaves"));
  EXPECT_EQ(0.0, matched.Field("CorrespondenceMerges"));

  const marrow::Skeleton skeleton = MakeQuadruped().Build();
  const marrow::FeatureGraph graph(skeleton, 8);
  marrow::ElectorsVoting voting(graph, graph, {});
  double last = -1.0;
  EXPECT_TRUE(voting.Vote(
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    }));
  EXPECT_EQ(1.0, last);
  EXPECT_FALSE(voting.Vote([](double fraction) { return fraction < 0.1; }));
}

TEST(ElectorsVoting, TheTolerancesDecideWhoMayMatch)
{
  SkeletonShape target = MakeQuadruped();
  target.Move("tail", -0.5, 0.0, 0.0);
  const auto pairs = [&](double path, double spatial)
  {
    vtkNew<vtkSkeletonCorrespondence> filter;
    filter->SetMatcherToElectorsVoting();
    filter->SetInputData(0, MakeQuadruped().BuildPolyData());
    filter->SetInputData(1, target.BuildPolyData());
    filter->SetCentricityTolerance(1.0);
    filter->SetPathTolerance(path);
    filter->SetSpatialTolerance(spatial);
    filter->Update();
    vtkTable* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
    return table->GetValueByName(0, "TerminalPairs").ToInt() +
      table->GetValueByName(0, "JunctionPairs").ToInt();
  };
  EXPECT_EQ(8, pairs(1.0, 2.0));
  EXPECT_LT(pairs(0.02, 2.0), 8);
  EXPECT_LT(pairs(1.0, 0.001), 8);
}

TEST(ElectorsVoting, SaysWhatIsWrong)
{
  const auto errorOf = [](vtkPolyData* source, int leaf)
  {
    vtkNew<vtkSkeletonCorrespondence> filter;
    filter->SetMatcherToElectorsVoting();
    filter->SetInputData(0, source);
    filter->SetInputData(1, MakeQuadruped().BuildPolyData());
    filter->SetLeafIndex(leaf);
    ErrorObserver errors(filter);
    filter->Update();
    return errors.Text();
  };
  EXPECT_NE(
    errorOf(MakeQuadruped().BuildPolyData(), 1).find("LeafIndex is 1 but there are only 1 leaves"),
    std::string::npos);
  // One node, and no branch.
  vtkNew<vtkPolyData> node;
  vtkNew<vtkPoints> point;
  point->InsertNextPoint(0.0, 0.0, 0.0);
  node->SetPoints(point);
  EXPECT_NE(errorOf(node, 0).find("Source: The skeleton "), std::string::npos) << errorOf(node, 0);
}
