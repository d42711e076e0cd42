// SPDX-License-Identifier: BSD-3-Clause
#include "MatchedShapes.h"

#include "ErrorObserver.h"
#include "SkeletonMatching.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace marrow::test;

TEST(SkeletonCorrespondence, MatchesASkeletonWithItself)
{
  const Matched matched(MakeQuadruped(), MakeQuadruped());
  matched.ExpectSame(QuadrupedTerminals());
  matched.ExpectSame({ "chest", "hip" });
  EXPECT_EQ(matched.BranchId(0, "hip", "chest"), matched.BranchId(1, "hip", "chest"));
  EXPECT_GE(matched.BranchId(0, "hip", "chest"), 0);
  // Regular nodes have no partner.
  EXPECT_EQ(-1, matched.NodeId(0, "neck"));
  EXPECT_GT(matched.Field("CorrespondenceConfidence"), 0.5);
}

TEST(SkeletonCorrespondence, IgnoresRotationAndScale)
{
  SkeletonShape target = MakeQuadruped();
  target.Transform(
    7.5 * Eigen::AngleAxisd(2.1, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix());
  const Matched matched(MakeQuadruped(), target);
  matched.ExpectSame(QuadrupedTerminals());
}

/// The squares of such lengths are no doubles.
TEST(SkeletonCorrespondence, MatchesSkeletonsInAnyUnit)
{
  const Matched matched(MakeQuadruped(), MakeQuadruped());
  for (const double unit : { 1e-200, 1e-100, 1e100, 1e200 })
  {
    SCOPED_TRACE(unit);
    marrow::Skeleton skeleton = MakeQuadruped().Build();
    for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
    {
      marrow::SkeletonNode& node = skeleton.Graph[n];
      node.Position *= unit;
      node.MSP *= unit;
      node.Radius *= unit;
    }
    skeleton.MeshDiagonal *= unit;
    skeleton.MeshMaximumMSP *= unit;
    vtkNew<vtkPolyData> target;
    marrow::ToPolyData(skeleton, target);
    matched.Filter->SetInputData(1, target);
    matched.Filter->Update();
    EXPECT_GT(matched.Field("CorrespondenceConfidence"), 0.5);
    vtkDataArray* ids[2];
    for (int side = 0; side < 2; ++side)
    {
      ids[side] = matched.Output(side)->GetPointData()->GetArray("CorrespondenceId");
    }
    for (vtkIdType n = 0; n < ids[0]->GetNumberOfTuples(); ++n)
    {
      EXPECT_EQ(ids[0]->GetTuple1(n), ids[1]->GetTuple1(n)) << "node " << n;
    }
  }
}

TEST(SkeletonCorrespondence, TurnsLeftToRightInAMirrorImage)
{
  SkeletonShape target = MakeQuadruped();
  target.Transform(Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal());
  const Matched matched(MakeQuadruped(), target);
  matched.ExpectSame({ "head", "tail" });
  EXPECT_EQ(matched.NodeId(0, "fore left"), matched.NodeId(1, "fore right"));
  EXPECT_EQ(matched.NodeId(0, "hind right"), matched.NodeId(1, "hind left"));
}

TEST(SkeletonCorrespondence, FollowsPoseAndProportion)
{
  SkeletonShape target = MakeQuadruped();
  target.Move("fore left", 0.35, 0.1, 0.05);
  target.Move("fore knee left", 0.2, 0.0, 0.05);
  target.Move("hind right", -0.35, 0.1, 0.0);
  target.Move("head", -0.1, -0.9, 0.3);
  target.Move("neck", 0.1, -0.4, 0.1);
  target.Move("tail", 0.1, 0.7, -0.2);
  const Matched matched(MakeQuadruped(), target);
  matched.ExpectSame(QuadrupedTerminals());
}

TEST(SkeletonCorrespondence, MergesASplitJunction)
{
  SkeletonShape target = MakeQuadruped();
  SkeletonShape split;
  split.Point("chest", 1.05, 1.0, 0.0, 0.24);
  split.Point("chest b", 0.95, 1.0, 0.0, 0.24);
  for (const char* name : { "hip", "neck", "head", "tailbase", "tail" })
  {
    const vtkSmartPointer<vtkPolyData> data = target.BuildPolyData();
    double p[3];
    data->GetPoint(target.Find(data, name), p);
    const double r = data->GetPointData()->GetArray("Radius")->GetTuple1(target.Find(data, name));
    split.Point(name, p[0], p[1], p[2], r);
  }
  for (const char* side : { "left", "right" })
  {
    const std::string s(side);
    const double z = s == "left" ? 0.25 : -0.25;
    split.Point("fore knee " + s, 1.05, 0.5, z, 0.09);
    split.Point("fore " + s, 1.0, 0.0, z, 0.06);
    split.Point("hind knee " + s, -0.1, 0.5, 1.1 * z, 0.11);
    split.Point("hind " + s, -0.15, -0.1, 1.1 * z, 0.07);
    split.Line({ s == "left" ? "chest" : "chest b", "fore knee " + s, "fore " + s });
    split.Line({ "hip", "hind knee " + s, "hind " + s });
  }
  split.Line({ "hip", "chest b", "chest" });
  split.Line({ "chest", "neck", "head" });
  split.Line({ "hip", "tailbase", "tail" });

  for (const bool splitSource : { false, true })
  {
    const Matched matched(splitSource ? split : target, splitSource ? target : split);
    matched.ExpectSame(QuadrupedTerminals());
    matched.ExpectSame({ "chest", "hip" });
    const int side = splitSource ? 0 : 1;
    EXPECT_EQ(matched.NodeId(side, "chest"), matched.NodeId(side, "chest b"));
    EXPECT_EQ(-1, matched.BranchId(side, "chest b", "chest"));
    EXPECT_GT(matched.Table()->GetValueByName(0, "Merges").ToInt(), 0);
  }
}

TEST(SkeletonCorrespondence, MergesBranchesAtASpur)
{
  SkeletonShape target = MakeQuadruped();
  // A spur half-way down the neck.
  target.Point("spur", 1.45, 1.25, 0.05, 0.08);
  target.Line({ "neck", "spur" });
  const Matched matched(MakeQuadruped(), target);
  ExpectPassed(matched, "spur");
  const int id = matched.BranchId(0, "chest", "head");
  // Both chains run between the same ids.
  for (const bool last : { false, true })
  {
    const auto endId = [&](int side)
    {
      return matched.Output(side)
        ->GetPointData()
        ->GetArray("CorrespondenceId")
        ->GetTuple1(ChainEnd(matched, side, id, last));
    };
    EXPECT_GE(endId(0), 0.0);
    EXPECT_EQ(endId(0), endId(1));
  }
  EXPECT_EQ(1,
    std::abs(matched.CellValue(1, "BranchCorrespondenceOrder", "chest", "neck") -
      matched.CellValue(1, "BranchCorrespondenceOrder", "neck", "head")));
}

TEST(SkeletonCorrespondence, LeavesAnEarWithoutPartner)
{
  SkeletonShape target = MakeQuadruped();
  for (const auto& [name, z] : { std::pair{ "ear left", 0.12 }, std::pair{ "ear right", -0.12 } })
  {
    target.Point(name, 1.5, 1.75, z, 0.03);
    target.Line({ "neck", name });
  }
  const Matched matched(MakeQuadruped(), target);
  matched.ExpectSame(QuadrupedTerminals());
  EXPECT_EQ(-1, matched.NodeId(1, "ear left"));
  EXPECT_EQ(-1, matched.NodeId(1, "ear right"));
}

TEST(SkeletonCorrespondence, MatchesChairsWithALoop)
{
  SkeletonShape target = MakeChair();
  target.Transform(Eigen::Vector3d(0.8, 1.3, 0.9).asDiagonal());
  const Matched matched(MakeChair(), target);
  matched.ExpectSame({ "seat", "front left", "front right", "back left", "back right" });
  const int id = matched.BranchId(0, "rail left", "rail right");
  EXPECT_GE(id, 0);
  EXPECT_EQ(id, matched.BranchId(1, "rail left", "rail right"));
  // The loops run the same way round.
  const auto walksFromLeft = [&](int side)
  {
    vtkPolyData* data = matched.Output(side);
    vtkIdList* ids = data->GetCell(matched.Cell(side, "rail left", "rail right"))->GetPointIds();
    const bool leftFirst =
      ids->IsId((side == 0 ? matched.SourceShape : matched.TargetShape).Find(data, "rail left")) <
      ids->IsId((side == 0 ? matched.SourceShape : matched.TargetShape).Find(data, "rail right"));
    const bool reversed =
      matched.CellValue(side, "BranchCorrespondenceReversed", "rail left", "rail right") != 0;
    return leftFirst != reversed;
  };
  EXPECT_EQ(walksFromLeft(0), walksFromLeft(1));
}

TEST(SkeletonCorrespondence, MatchesRings)
{
  SkeletonShape target = MakeRing();
  target.Transform(Eigen::Vector3d(2.0, 1.8, 2.0).asDiagonal());
  const Matched matched(MakeRing(), target);
  EXPECT_EQ(0, matched.BranchId(0, "ring a", "ring b"));
  EXPECT_EQ(0, matched.BranchId(1, "ring a", "ring b"));
}

TEST(SkeletonCorrespondence, MatchesSnakesHeadToHead)
{
  for (unsigned seed = 1; seed < 6; ++seed)
  {
    const Matched matched(MakeSnake(0.3), MakeSnake(1.0), seed);
    matched.ExpectSame({ "head", "tail" });
    EXPECT_EQ(0, matched.BranchId(0, "head", "tail"));
    EXPECT_EQ(0, matched.BranchId(1, "head", "tail"));
    EXPECT_EQ(2, matched.Table()->GetNumberOfRows());
  }
}

TEST(SkeletonCorrespondence, MatchesASnakeWithTheLongPathOfATree)
{
  const Matched matched(MakeSnake(0.3), MakeQuadruped());
  EXPECT_GE(matched.NodeId(0, "head"), 0);
  EXPECT_GE(matched.NodeId(0, "tail"), 0);
  EXPECT_EQ(1, matched.Table()->GetValueByName(0, "BranchPairs").ToInt());
}

TEST(SkeletonCorrespondence, MatchesComponentsByWhatTheyAre)
{
  const SkeletonShape both = MakeQuadrupedAndStick();
  SkeletonShape target = both;
  target.Transform(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY()).toRotationMatrix());
  const Matched matched(both, target);
  matched.ExpectSame(QuadrupedTerminals());
  matched.ExpectSame({ "stick top", "stick end" });
}

TEST(SkeletonCorrespondence, KeepsATreeOfManyAlikeArmsSmall)
{
  SkeletonShape target = MakeStar(8);
  target.Transform(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()).toRotationMatrix());
  const Matched matched(MakeStar(8), target);
  // The root, the pair of centers, and below it the six best of the 8! ways to match the arms.
  EXPECT_EQ(matched.Field("CorrespondenceTreeNodes"), 8);
  matched.ExpectSame({ "head" });
  // Any rotation of the arms is fair, but never a reflection: neighbours follow one another.
  std::vector<int> targetArm(8, -1);
  for (int i = 0; i < 8; ++i)
  {
    for (int j = 0; j < 8; ++j)
    {
      if (matched.NodeId(0, "arm " + std::to_string(i)) ==
        matched.NodeId(1, "arm " + std::to_string(j)))
      {
        targetArm[i] = j;
      }
    }
  }
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_EQ((targetArm[i] + 1) % 8, targetArm[(i + 1) % 8]);
  }
}

/// Every hub has six ways to match its arms that are as good as each other, after every way of those before.
TEST(SkeletonCorrespondence, KeepsFewNodesOnALevelOfItsTree)
{
  constexpr int hubs = 3;
  SkeletonShape shape;
  for (int hub = 0; hub < hubs; ++hub)
  {
    const std::string name = "hub " + std::to_string(hub);
    shape.Point(name, 4.0 * hub, 0.0, 0.0, 0.3);
    for (int arm = 0; arm < 6; ++arm)
    {
      const double angle = marrow::Pi / 3.0 * arm;
      const std::string tip = name + " arm " + std::to_string(arm);
      shape.Point(tip, 4.0 * hub, std::cos(angle), std::sin(angle), 0.05);
      shape.Line({ name, tip });
    }
    if (hub > 0)
    {
      shape.Line({ "hub " + std::to_string(hub - 1), name });
    }
  }
  const Matched matched(shape, shape);
  // A level keeps 48: without that bound there are five times as many.
  EXPECT_LE(
    matched.Field("CorrespondenceTreeNodes"), 1 + 48 * matched.Field("CorrespondenceTreeHeight"));
  EXPECT_LE(matched.Field("CorrespondenceTreeNodes"), 300);
  matched.ExpectSame({ "hub 1", "hub 2" });
}

TEST(SkeletonCorrespondence, DoesNotDependOnTheNumberingOfNodes)
{
  SkeletonShape target = MakeQuadruped();
  target.Point("spur", 1.45, 1.25, 0.05, 0.08);
  target.Line({ "neck", "spur" });
  target.Move("tail", 0.1, 0.7, -0.2);
  const Matched reference(MakeQuadruped(), target);
  for (unsigned seed = 1; seed < 6; ++seed)
  {
    const Matched matched(MakeQuadruped(), target, seed);
    for (const std::string& name : QuadrupedTerminals())
    {
      for (const std::string& other : QuadrupedTerminals())
      {
        EXPECT_EQ(reference.NodeId(0, name) == reference.NodeId(1, other),
          matched.NodeId(0, name) == matched.NodeId(1, other))
          << name << " and " << other;
      }
    }
    const double cost = reference.Table()->GetValueByName(0, "GlobalCost").ToDouble();
    EXPECT_NEAR(
      cost, matched.Table()->GetValueByName(0, "GlobalCost").ToDouble(), 1e-9 * std::abs(cost));
  }
}

TEST(SkeletonCorrespondence, ReportsTheTreeAndItsLeaves)
{
  const Matched matched(MakeQuadruped(), MakeQuadruped());
  const double leaves = matched.Field("CorrespondenceLeaves");
  EXPECT_GE(leaves, 2.0);
  EXPECT_GE(matched.Table()->GetNumberOfRows(), 2);
  EXPECT_GT(matched.Field("CorrespondenceTreeNodes"), leaves);
  EXPECT_GE(matched.Field("CorrespondenceTreeHeight"), 3.0);
  EXPECT_GE(matched.Field("CorrespondenceCorePairs"), 1.0);
  EXPECT_GE(matched.Field("CorrespondenceMerges"), 0.0);
  EXPECT_GE(matched.Field("CorrespondenceClusters"), 2.0);
  for (vtkIdType row = 1; row < matched.Table()->GetNumberOfRows(); ++row)
  {
    EXPECT_LE(matched.Table()->GetValueByName(row - 1, "GlobalCost").ToDouble(),
      matched.Table()->GetValueByName(row, "GlobalCost").ToDouble());
  }
  EXPECT_EQ(2, matched.Table()->GetValueByName(0, "JunctionPairs").ToInt());
  EXPECT_EQ(6, matched.Table()->GetValueByName(0, "TerminalPairs").ToInt());
  EXPECT_EQ(7, matched.Table()->GetValueByName(0, "BranchPairs").ToInt());
  EXPECT_NEAR(1.0, matched.Table()->GetValueByName(0, "SourceCoverage").ToDouble(), 1e-12);

  // Every leaf tells another story, some other also of the terminals.
  bool differs = false;
  std::set<std::vector<std::vector<vtkIdType>>> stories;
  for (int leaf = 0; leaf < matched.Table()->GetNumberOfRows(); ++leaf)
  {
    const Matched other(MakeQuadruped(), MakeQuadruped(), 0, leaf);
    std::map<int, std::vector<vtkIdType>> pairs;
    for (int side = 0; side < 2; ++side)
    {
      vtkPolyData* data = other.Output(side);
      vtkDataArray* nodes = data->GetPointData()->GetArray("CorrespondenceId");
      vtkDataArray* branches = data->GetCellData()->GetArray("BranchCorrespondenceId");
      for (vtkIdType i = 0; i < data->GetNumberOfPoints() + data->GetNumberOfCells(); ++i)
      {
        const vtkIdType cell = i - data->GetNumberOfPoints();
        const int id = static_cast<int>(cell < 0 ? nodes->GetTuple1(i) : branches->GetTuple1(cell));
        if (id >= 0)
        {
          pairs[cell < 0 ? id : -1 - id].insert(pairs[cell < 0 ? id : -1 - id].end(), { side, i });
        }
      }
    }
    std::vector<std::vector<vtkIdType>> story;
    for (const auto& pair : pairs)
    {
      story.push_back(pair.second);
    }
    std::sort(story.begin(), story.end());
    EXPECT_TRUE(stories.insert(story).second) << "leaf " << leaf;
    for (const std::string& name : QuadrupedTerminals())
    {
      differs = differs || other.NodeId(0, name) != other.NodeId(1, name);
    }
  }
  EXPECT_TRUE(differs);
}

TEST(SkeletonCorrespondence, KeepsTheInputsArrays)
{
  const vtkSmartPointer<vtkPolyData> source = MakeQuadruped().BuildPolyData();
  vtkNew<vtkDoubleArray> mine;
  mine->SetName("Mine");
  mine->SetNumberOfTuples(source->GetNumberOfPoints());
  mine->Fill(3.0);
  source->GetPointData()->AddArray(mine);
  vtkNew<vtkSkeletonCorrespondence> filter;
  filter->SetInputData(0, source);
  filter->SetInputData(1, MakeQuadruped().BuildPolyData());
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  for (const char* name : { "Mine", "AGD", "MSP", "Radius", "NodeType", "VertexCount" })
  {
    EXPECT_TRUE(output->GetPointData()->HasArray(name)) << name;
  }
  EXPECT_TRUE(output->GetFieldData()->HasArray("MeshDiagonal"));
  EXPECT_FALSE(source->GetPointData()->HasArray("CorrespondenceId"));
  EXPECT_FALSE(source->GetFieldData()->HasArray("CorrespondenceLeaves"));
}

TEST(SkeletonCorrespondence, IsConsistentOnAnything)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectConsistent(Matched(MakeRandomShape(seed), MakeRandomShape(1000 + seed * 7), 0, 0,
      seed % 5 != 0 ? Matched::Selection::Global : Matched::Selection::Paper));
  }
}

TEST(SkeletonCorrespondence, KnowsAStrangerByItsConfidence)
{
  SkeletonShape sister = MakeQuadruped();
  sister.Move("head", 0.1, -0.2, 0.1);
  sister.Move("tail", 0.0, 0.3, 0.0);
  const Matched same(MakeQuadruped(), sister);
  const Matched other(MakeQuadruped(), MakeStar(8));
  EXPECT_GT(same.Field("CorrespondenceConfidence"), other.Field("CorrespondenceConfidence") + 0.2);
}

TEST(SkeletonCorrespondence, PaperSelectionMatchesTheSame)
{
  const Matched matched(MakeQuadruped(), MakeQuadruped(), 0, 0, Matched::Selection::Paper);
  matched.ExpectSame({ "chest", "hip", "head", "tail" });
  for (vtkIdType row = 1; row < matched.Table()->GetNumberOfRows(); ++row)
  {
    EXPECT_LE(matched.Table()->GetValueByName(row - 1, "PaperCost").ToDouble(),
      matched.Table()->GetValueByName(row, "PaperCost").ToDouble());
    EXPECT_EQ(0, matched.Table()->GetValueByName(row, "Refined").ToInt());
  }
}

TEST(SkeletonCorrespondence, HasTheAlgorithmsDefaults)
{
  const marrow::TreeParameters tree;
  const marrow::MatchingParameters matching;
  vtkNew<vtkSkeletonCorrespondence> filter;
  EXPECT_EQ(tree.JunctionThreshold, filter->GetJunctionThreshold());
  EXPECT_EQ(tree.MergeDistance, filter->GetMergeDistance());
  EXPECT_EQ(tree.ClusterDistance, filter->GetClusterDistance());
  EXPECT_EQ(matching.DescriptorPieces, filter->GetDescriptorPieces());
  EXPECT_EQ(matching.GlobalSelection, filter->GetGlobalSelection());
  EXPECT_EQ(0, filter->GetLeafIndex());
  EXPECT_EQ(vtkSkeletonCorrespondence::CORRESPONDENCE_TREE, filter->GetMatcher());
  EXPECT_EQ(matching.Voting.CentricityTolerance, filter->GetCentricityTolerance());
  EXPECT_EQ(matching.Voting.PathTolerance, filter->GetPathTolerance());
  EXPECT_EQ(matching.Voting.SpatialTolerance, filter->GetSpatialTolerance());
}

TEST(SkeletonCorrespondence, SaysWhatIsWrong)
{
  const auto errorOf = [](vtkPolyData* source, vtkPolyData* target, int leaf = 0)
  {
    vtkNew<vtkSkeletonCorrespondence> filter;
    filter->SetInputData(0, source);
    filter->SetInputData(1, target);
    filter->SetLeafIndex(leaf);
    ErrorObserver errors(filter);
    filter->Update();
    return errors.Text();
  };
  const vtkSmartPointer<vtkPolyData> good = MakeQuadruped().BuildPolyData();
  vtkNew<vtkPolyData> empty;
  EXPECT_NE(errorOf(empty, good).find("Source: The skeleton is empty"), std::string::npos);
  EXPECT_NE(errorOf(good, empty).find("Target: The skeleton is empty"), std::string::npos);
  const vtkSmartPointer<vtkPolyData> bare = MakeQuadruped().BuildPolyData();
  bare->GetPointData()->RemoveArray("AGD");
  EXPECT_NE(errorOf(good, bare).find("no point array \"AGD\""), std::string::npos);
  EXPECT_NE(
    errorOf(good, good, 100000).find("LeafIndex is 100000 but there are only"), std::string::npos);
  EXPECT_EQ("", errorOf(good, good));
}
