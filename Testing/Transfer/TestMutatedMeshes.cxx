// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "MutatedMeshes.h"
#include "TransferTestData.h"

#include <vtkCellArray.h>
#include <vtkMSPField.h>
#include <vtkPoints.h>

#include <cmath>
#include <set>

using namespace marrow;
using namespace marrow::test;

namespace
{
Data ToPolyData(const PolygonMesh& mesh)
{
  auto data = Data::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (int c = 0; c < mesh.NumberOfPolygons(); ++c)
  {
    polygons->InsertNextCell(mesh.SizeOf(c));
    for (int k = 0; k < mesh.SizeOf(c); ++k)
    {
      polygons->InsertCellPoint(mesh.CornersOf(c)[k]);
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

/// Either nothing is wrong, or one sentence says what.
bool IsDone(const ErrorObserver& errors)
{
  EXPECT_TRUE(errors.Errors.empty() || errors.HasError("None of the mesh's faces has an area"))
    << errors.Text();
  return errors.Errors.empty();
}
}

/// Whatever is done to a mesh, it is measured, has a skeleton, and is labelled face by face.
TEST(MutatedMeshes, AreMeasuredAndLabelled)
{
  CreatureOptions options;
  options.Faces = 1000;
  const Data source = MakeCreature(vtkCreatureSource::QUADRUPED, options).Mesh;
  const std::vector<int> sourceLabels = LabelsOf(source);
  const std::set<int> known(sourceLabels.begin(), sourceLabels.end());
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source);
  const int count = NumberOfMutatedMeshes(20);
  for (int seed = 0; seed < count && !HasFailure(); ++seed)
  {
    std::string what;
    const Data mesh = ToPolyData(MakeMutatedMesh(seed, what));
    SCOPED_TRACE(what);
    {
      vtkNew<vtkMSPField> field;
      ErrorObserver errors(field);
      field->SetInputData(mesh);
      field->Update();
      if (!IsDone(errors))
      {
        continue;
      }
      vtkDataArray* perimeters = field->GetOutput()->GetPointData()->GetArray(names::MSP);
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        ASSERT_TRUE(std::isfinite(perimeters->GetTuple1(i))) << "point " << i;
      }
    }
    transfer->SetInputData(1, mesh);
    ErrorObserver errors(transfer);
    transfer->Update();
    EXPECT_TRUE(IsDone(errors));
    const std::vector<int> labels = LabelsOf(Output(transfer));
    ASSERT_EQ(static_cast<vtkIdType>(labels.size()), mesh->GetNumberOfCells());
    for (const int label : labels)
    {
      ASSERT_TRUE(known.count(label)) << label;
    }
  }
}
