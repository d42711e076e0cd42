// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MatchedShapes_h
#define marrow_MatchedShapes_h

#include "SkeletonShapes.h"

#include "vtkSkeletonCorrespondence.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace marrow::test
{
/// Two shapes and what vtkSkeletonCorrespondence makes of them.
struct Matched
{
  enum class Selection
  {
    Global,
    Paper,
    Electors
  };

  Matched(const SkeletonShape& source, const SkeletonShape& target, unsigned seed = 0, int leaf = 0,
    Selection selection = Selection::Global)
    : SourceShape(source)
    , TargetShape(target)
  {
    this->Filter->SetInputData(0, source.BuildPolyData(seed));
    this->Filter->SetInputData(1, target.BuildPolyData(seed == 0 ? 0 : seed + 1));
    this->Filter->SetLeafIndex(leaf);
    this->Filter->SetGlobalSelection(selection == Selection::Global);
    this->Filter->SetMatcher(selection == Selection::Electors
        ? vtkSkeletonCorrespondence::ELECTORS_VOTING
        : vtkSkeletonCorrespondence::CORRESPONDENCE_TREE);
    this->Filter->Update();
  }
  vtkPolyData* Output(int side) const
  {
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(side));
  }
  vtkTable* Table() const { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2)); }
  int NodeId(int side, const std::string& name) const
  {
    vtkPolyData* data = this->Output(side);
    const SkeletonShape& shape = side == 0 ? this->SourceShape : this->TargetShape;
    return static_cast<int>(
      data->GetPointData()->GetArray("CorrespondenceId")->GetTuple1(shape.Find(data, name)));
  }
  /// The cell that has both points on it.
  vtkIdType Cell(int side, const std::string& a, const std::string& b) const
  {
    vtkPolyData* data = this->Output(side);
    const SkeletonShape& shape = side == 0 ? this->SourceShape : this->TargetShape;
    for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
    {
      vtkIdList* ids = data->GetCell(c)->GetPointIds();
      if (ids->IsId(shape.Find(data, a)) >= 0 && ids->IsId(shape.Find(data, b)) >= 0)
      {
        return c;
      }
    }
    return -1;
  }
  int CellValue(int side, const char* array, const std::string& a, const std::string& b) const
  {
    const vtkIdType cell = this->Cell(side, a, b);
    return cell < 0
      ? -99
      : static_cast<int>(this->Output(side)->GetCellData()->GetArray(array)->GetTuple1(cell));
  }
  int BranchId(int side, const std::string& a, const std::string& b) const
  {
    return this->CellValue(side, "BranchCorrespondenceId", a, b);
  }
  double Field(const char* name) const
  {
    vtkDataArray* array = this->Output(0)->GetFieldData()->GetArray(name);
    return array ? array->GetTuple1(0) : -99.0;
  }
  void ExpectSame(const std::vector<std::string>& names) const
  {
    for (const std::string& name : names)
    {
      EXPECT_GE(this->NodeId(0, name), 0) << name;
      EXPECT_EQ(this->NodeId(0, name), this->NodeId(1, name)) << name;
    }
  }

  vtkNew<vtkSkeletonCorrespondence> Filter;
  SkeletonShape SourceShape;
  SkeletonShape TargetShape;
};

/// The point where a matched chain begins or ends on one side, by walking its polylines as the
/// arrays say.
inline vtkIdType ChainEnd(const Matched& matched, int side, int id, bool last)
{
  vtkPolyData* data = matched.Output(side);
  vtkIdType result = -1;
  int best = -1;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    const auto value = [&](const char* name)
    { return static_cast<int>(data->GetCellData()->GetArray(name)->GetTuple1(c)); };
    const int order = value("BranchCorrespondenceOrder");
    if (value("BranchCorrespondenceId") != id || (last ? order < best : order != 0))
    {
      continue;
    }
    best = order;
    vtkIdList* ids = data->GetCell(c)->GetPointIds();
    const bool reversed = value("BranchCorrespondenceReversed") != 0;
    result = ids->GetId(last != reversed ? ids->GetNumberOfIds() - 1 : 0);
  }
  return result;
}

/// A quadruped, and beside it a stick.
inline SkeletonShape MakeQuadrupedAndStick()
{
  SkeletonShape both = MakeQuadruped();
  both.Point("stick top", 4.0, 1.0, 0.0, 0.1);
  both.Point("stick end", 4.0, 0.0, 0.0, 0.05);
  both.Line({ "stick top", "stick end" });
  return both;
}

/// Of a quadruped and one whose neck has a spur: it has no partner, and the neck is one chain past it.
inline void ExpectPassed(const Matched& matched, const std::string& spur)
{
  matched.ExpectSame(QuadrupedTerminals());
  EXPECT_EQ(-1, matched.NodeId(1, spur));
  EXPECT_EQ(-1, matched.NodeId(1, "neck"));
  const int id = matched.BranchId(0, "chest", "head");
  EXPECT_GE(id, 0);
  EXPECT_EQ(id, matched.BranchId(1, "chest", "neck"));
  EXPECT_EQ(id, matched.BranchId(1, "neck", "head"));
  EXPECT_EQ(-1, matched.BranchId(1, "neck", spur));
}

/// A random tree with some loops, in one or two components.
inline SkeletonShape MakeRandomShape(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  SkeletonShape shape;
  const int points = 2 + static_cast<int>(uniform(random) * 14);
  const auto name = [](int i) { return "p" + std::to_string(i); };
  for (int i = 0; i < points; ++i)
  {
    shape.Point(
      name(i), uniform(random), uniform(random), uniform(random), 0.02 + 0.1 * uniform(random));
    if (i > 0 && (i != points / 2 || seed % 3 != 0 || i + 1 >= points))
    {
      shape.Line({ name(i), name(static_cast<int>(uniform(random) * i)) });
    }
  }
  if (points / 2 + 1 < points && seed % 3 == 0)
  {
    shape.Line({ name(points / 2), name(points / 2 + 1) });
  }
  for (int loop = 0; loop < static_cast<int>(seed % 4) && points > 3; ++loop)
  {
    shape.Line({ name(0), name(points - 1 - loop % 2) });
  }
  return shape;
}

/// What holds of any result: equal ids on both sides, chains that run from equal ids to equal ids, a
/// confidence in [0,1].
inline void ExpectConsistent(const Matched& matched)
{
  ASSERT_NE(nullptr, matched.Table());
  ASSERT_GE(matched.Table()->GetNumberOfRows(), 1);
  std::set<int> ids[2];
  for (int side = 0; side < 2; ++side)
  {
    vtkPolyData* data = matched.Output(side);
    vtkDataArray* nodeIds = data->GetPointData()->GetArray("CorrespondenceId");
    for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
    {
      ids[side].insert(static_cast<int>(nodeIds->GetTuple1(p)));
    }
  }
  ids[0].insert(-1);
  ids[1].insert(-1);
  EXPECT_EQ(ids[0], ids[1]);
  const int pairs = matched.Table()->GetValueByName(0, "BranchPairs").ToInt();
  for (int id = 0; id < pairs; ++id)
  {
    for (const bool last : { false, true })
    {
      int ends[2];
      for (int side = 0; side < 2; ++side)
      {
        const vtkIdType end = ChainEnd(matched, side, id, last);
        ASSERT_GE(end, 0);
        ends[side] = static_cast<int>(
          matched.Output(side)->GetPointData()->GetArray("CorrespondenceId")->GetTuple1(end));
      }
      EXPECT_GE(ends[0], 0);
      EXPECT_EQ(ends[0], ends[1]);
    }
  }
  const double confidence = matched.Field("CorrespondenceConfidence");
  EXPECT_GE(confidence, 0.0);
  EXPECT_LE(confidence, 1.0);
}
}

#endif
