// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonResult_h
#define marrow_SkeletonResult_h

#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCommand.h>
#include <vtkMSPField.h>

#include <cmath>
#include <vector>

/// What holds of every filter that makes a skeleton. Link Marrow::Measures, Marrow::Creatures,
/// Marrow::Core and VTK::FiltersCore.
namespace marrow::test
{
/// The outputs of such a filter, and its skeleton with φ.
struct SkeletonResult
{
  template <typename Filter>
  explicit SkeletonResult(Filter* filter)
  {
    filter->Update();
    this->PolyData = filter->GetOutput(0);
    this->Mesh = filter->GetOutput(1);
    EXPECT_EQ(ToSkeleton(this->PolyData, this->Skeleton), "");
    EXPECT_TRUE(GetArray(this->Mesh->GetPointData(), names::SkeletonNodeId,
      static_cast<int>(this->Mesh->GetNumberOfPoints()), this->NodeOfVertex));
    EXPECT_TRUE(SetNodeOfVertices(this->Skeleton, this->NodeOfVertex));
    for (int n = 0; n < this->Skeleton.NumberOfNodes(); ++n)
    {
      this->Terminals += this->Skeleton.TypeOf(n) == NodeType::Terminal;
    }
  }

  marrow::Skeleton Skeleton;
  std::vector<int> NodeOfVertex;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> PolyData;
  int Terminals = 0;
};

/// Side by side, one component each.
inline vtkSmartPointer<vtkPolyData> MakeTwoCylinders()
{
  const auto one = ToPolyData(MakeCylinder(1.0, 10.0, 24, 60));
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(one);
  both->AddInputData(Transformed(
    one, [](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p + Eigen::Vector3d(9, 0, 0); }));
  both->Update();
  return both->GetOutput();
}

/// Of a cylinder of radius 1 along z, its middle at the origin.
inline void ExpectCylinderAxis(
  const SkeletonResult& result, double length, double leastShare, double offAxis)
{
  EXPECT_EQ(result.Terminals, 2);
  ASSERT_EQ(result.Skeleton.NumberOfBranches(), 1);
  EXPECT_GT(result.Skeleton.TotalLength(), leastShare * length);
  EXPECT_LT(result.Skeleton.TotalLength(), 1.02 * length);
  for (int n = 0; n < result.Skeleton.NumberOfNodes(); ++n)
  {
    const SkeletonNode& node = result.Skeleton.Graph[n];
    EXPECT_LT(std::hypot(node.Position.x(), node.Position.y()), offAxis);
    if (std::abs(node.Position.z()) < 0.35 * length)
    {
      EXPECT_NEAR(node.Radius, 1.0, 0.05);
      EXPECT_NEAR(node.MSP, 2.0 * Pi, 0.1);
    }
  }
}

/// Of a torus.
inline void ExpectOneClosedBranch(const SkeletonResult& result, double radius)
{
  EXPECT_EQ(result.Terminals, 0);
  EXPECT_EQ(result.Skeleton.NumberOfLoops(), 1);
  ASSERT_EQ(result.Skeleton.NumberOfBranches(), 1);
  EXPECT_TRUE(result.Skeleton.Branches[0].IsLoop());
  EXPECT_NEAR(result.Skeleton.TotalLength(), 2.0 * Pi * radius, 0.05 * 2.0 * Pi * radius);
}

/// The mesh with the arrays of vtkMSPField, on data of its own that may be changed.
inline vtkSmartPointer<vtkPolyData> WithMeasures(vtkPolyData* mesh)
{
  vtkNew<vtkMSPField> field;
  field->SetInputData(mesh);
  field->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(field->GetOutput());
  return copy;
}

/// Of a mesh whose AGD was set to one value.
inline void ExpectAGD(const SkeletonResult& result, double value)
{
  for (int n = 0; n < result.Skeleton.NumberOfNodes(); ++n)
  {
    EXPECT_DOUBLE_EQ(result.Skeleton.Graph[n].AGD, value);
  }
}

inline void ExpectKept(vtkPolyData* mesh, const SkeletonResult& result)
{
  EXPECT_EQ(result.Mesh->GetCellData()->GetArray(names::SegmentId),
    mesh->GetCellData()->GetArray(names::SegmentId));
  EXPECT_EQ(result.Mesh->GetPoints(), mesh->GetPoints());
}

/// Asks a filter to stop when its progress is beyond `After`.
struct AbortObserver : vtkCommand
{
  static AbortObserver* New() { return new AbortObserver; }
  void Execute(vtkObject* caller, unsigned long, void* fraction) override
  {
    if (*static_cast<double*>(fraction) > this->After)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }
  double After = -1.0;
};
}

#endif
