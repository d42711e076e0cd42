// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMSPField.h"

#include "ErrorObserver.h"
#include "MeasureShapes.h"
#include "TestMeshes.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

using namespace marrow;
using namespace marrow::test;

namespace
{
const char* const ArrayNames[] = { "AGD", "MSP", "MSPCenter", "MSPNormal", "MSPGradient",
  "MSPValid", "DihedralAngle" };

void ExpectError(vtkPolyData* input, const char* part)
{
  vtkNew<vtkMSPField> filter;
  ErrorObserver errors(filter);
  filter->SetInputData(input);
  filter->Update();
  EXPECT_TRUE(errors.HasError(part)) << errors.Text();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("MSP"), nullptr);
}
}

TEST(MSPField, WritesTheArraysOfTheContract)
{
  const TriangleMesh mesh = MakeEgg(3);
  vtkNew<vtkMSPField> filter;
  filter->SetInputData(ToPolyData(mesh));
  filter->Update();
  vtkPointData* points = filter->GetOutput()->GetPointData();
  const int components[] = { 1, 1, 3, 3, 3, 1, 1 };
  for (int i = 0; i < 7; ++i)
  {
    vtkDataArray* array = points->GetArray(ArrayNames[i]);
    ASSERT_NE(array, nullptr) << ArrayNames[i];
    EXPECT_EQ(array->GetNumberOfComponents(), components[i]) << ArrayNames[i];
    EXPECT_EQ(array->GetNumberOfTuples(), mesh.NumberOfVertices()) << ArrayNames[i];
    const bool isFlag = std::string(ArrayNames[i]) == "MSPValid";
    EXPECT_EQ(array->GetDataType(), isFlag ? VTK_UNSIGNED_CHAR : VTK_DOUBLE) << ArrayNames[i];
    for (int c = 0; c < components[i]; ++c)
    {
      double range[2];
      array->GetFiniteRange(range, c);
      EXPECT_TRUE(std::isfinite(range[0]) && std::isfinite(range[1])) << ArrayNames[i];
    }
  }
  double range[2];
  points->GetArray("AGD")->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 1.0);
  points->GetArray("MSPValid")->GetRange(range);
  EXPECT_EQ(range[0], 1.0);
}

TEST(MSPField, GradientPointsToTheThickerPart)
{
  TriangleMesh cone = MakeCylinder(1.0, 12.0, 36, 60);
  for (auto& p : cone.Points)
  {
    const double scale = 1.0 + 0.1 * p.z() / 2.0;
    p.x() *= scale;
    p.y() *= scale;
  }
  vtkNew<vtkMSPField> filter;
  filter->SetInputData(ToPolyData(cone));
  filter->Update();
  vtkDataArray* gradient = filter->GetOutput()->GetPointData()->GetArray("MSPGradient");
  for (int v = 0; v < cone.NumberOfVertices(); ++v)
  {
    if (std::abs(cone.Points[v].z()) < 2.5)
    {
      double g[3];
      gradient->GetTuple(v, g);
      ASSERT_GT(g[2], 0.3) << v; // 2π × 0.05 = 0.31 along the axis, times the formula's factor
      ASSERT_LT(std::hypot(g[0], g[1]), 0.3 * g[2]) << v;
    }
  }
}

TEST(MSPField, PassesTheMeshAndItsArraysThrough)
{
  const TriangleMesh mesh = MakeEgg(2);
  auto input = ToPolyData(mesh);
  vtkNew<vtkIntArray> segments;
  segments->SetName("SegmentId");
  segments->SetNumberOfValues(mesh.NumberOfTriangles());
  segments->FillValue(3);
  input->GetCellData()->SetScalars(segments);
  vtkNew<vtkDoubleArray> own;
  own->SetName("Temperature");
  own->SetNumberOfValues(mesh.NumberOfVertices());
  own->FillValue(1.5);
  input->GetPointData()->SetScalars(own);
  vtkNew<vtkDoubleArray> old;
  old->SetName("MSP");
  old->SetNumberOfValues(mesh.NumberOfVertices());
  old->FillValue(-1.0);
  input->GetPointData()->AddArray(old);
  vtkNew<vtkDoubleArray> field;
  field->SetName("Origin");
  field->InsertNextValue(7.0);
  input->GetFieldData()->AddArray(field);

  vtkNew<vtkMSPField> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), input->GetPoints());
  EXPECT_EQ(output->GetPolys(), input->GetPolys());
  EXPECT_EQ(output->GetCellData()->GetScalars(), segments.Get());
  EXPECT_EQ(output->GetPointData()->GetScalars(), own.Get());
  EXPECT_EQ(output->GetFieldData()->GetArray("Origin"), field.Get());
  EXPECT_GT(output->GetPointData()->GetArray("MSP")->GetTuple1(0), 0.0);
  // The input keeps what it had and gets nothing.
  EXPECT_EQ(input->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(input->GetPointData()->GetArray("MSP")->GetTuple1(0), -1.0);
}

TEST(MSPField, GivesTheSameBitsOnAnyNumberOfThreads)
{
  auto input = ToPolyData(MakeEgg(4));
  vtkSmartPointer<vtkPolyData> reference;
  for (int threads : { 4, 2, 1 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkMSPField> filter;
    filter->SetInputData(input);
    filter->Update();
    if (!reference)
    {
      reference = filter->GetOutput();
      continue;
    }
    for (const char* name : ArrayNames)
    {
      vtkDataArray* a = reference->GetPointData()->GetArray(name);
      vtkDataArray* b = filter->GetOutput()->GetPointData()->GetArray(name);
      const std::size_t size = static_cast<std::size_t>(a->GetNumberOfValues()) *
        static_cast<std::size_t>(a->GetDataTypeSize());
      EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size), 0)
        << name << " on " << threads << " threads";
    }
  }
  vtkSMPTools::Initialize(0);
}

TEST(MSPField, AGDMethodsAgree)
{
  vtkNew<vtkMSPField> filter;
  filter->SetInputData(ToPolyData(MakeEgg(4)));
  EXPECT_EQ(filter->GetAGDMethod(), vtkMSPField::SAMPLED);
  filter->Update();
  vtkSmartPointer<vtkDataArray> sampled = filter->GetOutput()->GetPointData()->GetArray("AGD");
  filter->SetAGDMethodToAllPairs();
  filter->Update();
  vtkDataArray* all = filter->GetOutput()->GetPointData()->GetArray("AGD");
  double sum = 0.0;
  for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
  {
    sum += std::abs(all->GetTuple1(i) - sampled->GetTuple1(i));
  }
  EXPECT_LT(sum / all->GetNumberOfTuples(), 0.01);
  EXPECT_GT(sum, 0.0) << "the second method was not run";
}

TEST(MSPField, ClampsAndPrintsItsParameters)
{
  vtkNew<vtkMSPField> filter;
  EXPECT_EQ(filter->GetNumberOfSlices(), 12);
  filter->SetNumberOfSlices(1);
  EXPECT_EQ(filter->GetNumberOfSlices(), 2);
  filter->SetNumberOfSlices(1000);
  EXPECT_EQ(filter->GetNumberOfSlices(), 180);
  filter->SetAGDMethod(9);
  EXPECT_EQ(filter->GetAGDMethod(), vtkMSPField::ALL_PAIRS);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("NumberOfSlices: 180"), std::string::npos);
  EXPECT_NE(text.str().find("AGDMethod: ALL_PAIRS"), std::string::npos);
}

TEST(MSPField, AcceptsOpenMeshesAndSeveralComponents)
{
  const TriangleMesh open = Without(MakeCylinder(1.0, 6.0, 24, 30),
    [](const TriangleMesh& m, int t) { return m.Centroid(t).z() > 3.0 - 1e-9; });
  const TriangleMesh mesh = Joined(open, Translated(MakeEgg(2), Eigen::Vector3d(9.0, 0.0, 0.0)));
  vtkNew<vtkMSPField> filter;
  ErrorObserver errors(filter);
  filter->SetInputData(ToPolyData(mesh));
  filter->Update();
  EXPECT_EQ(errors.Text(), "");
  for (const char* name : ArrayNames)
  {
    vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        ASSERT_TRUE(std::isfinite(array->GetComponent(i, c))) << name << " at " << i;
      }
    }
  }
}

TEST(MSPField, SaysWhatIsWrong)
{
  vtkNew<vtkPolyData> empty;
  ExpectError(empty, "The mesh has no face");

  TriangleMesh infinite = MakeSphere(1.0, 1);
  infinite.Points[2].x() = std::nan("");
  ExpectError(ToPolyData(infinite), "not finite");
}

TEST(MSPField, MeasuresWhatIsNoCleanMeshByItsWorkingSurface)
{
  const auto expectMended = [](vtkPolyData* mesh, const std::string& note)
  {
    vtkNew<vtkMSPField> filter;
    ErrorObserver errors(filter);
    filter->SetInputData(mesh);
    filter->Update();
    EXPECT_TRUE(errors.Text().empty()) << errors.Text();
    vtkPolyData* output = filter->GetOutput();
    EXPECT_EQ(output->GetPolys(), mesh->GetPolys());
    vtkAbstractArray* said = output->GetFieldData()->GetAbstractArray("WorkingSurfaceNote");
    ASSERT_TRUE(said);
    EXPECT_EQ(said->GetVariantValue(0).ToString(), note);
    // The sphere's measure at each of its points.
    vtkDataArray* perimeters = output->GetPointData()->GetArray("MSP");
    for (vtkIdType i = 0; i < MakeSphere(1.0, 3).NumberOfVertices(); ++i)
    {
      EXPECT_NEAR(perimeters->GetTuple1(i), 2.0 * Pi, 0.2) << i;
    }
  };
  TriangleMesh fin = MakeSphere(1.0, 3);
  fin.Triangles.push_back(fin.Triangles[0]);
  expectMended(ToPolyData(fin), "left out 1 face that is there twice");

  TriangleMesh flipped = MakeSphere(1.0, 3);
  std::swap(flipped.Triangles[0][0], flipped.Triangles[0][1]);
  expectMended(ToPolyData(flipped), "turned 1 face");
}

TEST(MSPField, AFineMeshMayBeMeasuredOnACoarseSurface)
{
  const TriangleMesh fine = MakeCylinder(1.0, 12.0, 60, 200);
  vtkNew<vtkMSPField> exact;
  exact->SetInputData(ToPolyData(fine));
  exact->Update();
  vtkNew<vtkMSPField> coarse;
  coarse->SetInputData(ToPolyData(fine));
  coarse->SetMaximumFaces(3000);
  coarse->Update();
  vtkDataArray* expected = exact->GetOutput()->GetPointData()->GetArray("MSP");
  vtkDataArray* found = coarse->GetOutput()->GetPointData()->GetArray("MSP");
  ASSERT_EQ(found->GetNumberOfTuples(), fine.NumberOfVertices());
  int distinct = 0;
  for (int v = 0; v < fine.NumberOfVertices(); ++v)
  {
    if (std::abs(fine.Points[v].z()) < 5.0)
    {
      EXPECT_NEAR(found->GetTuple1(v), expected->GetTuple1(v), 0.1 * expected->GetTuple1(v)) << v;
      distinct += found->GetTuple1(v) != expected->GetTuple1(v);
    }
  }
  EXPECT_GT(distinct, 0); // or it was not simplified
}

// Of several threads the one that reports may have to wait for the others; alone it reports each step.
class MSPFieldProgress : public testing::Test
{
protected:
  void SetUp() override { vtkSMPTools::SetBackend("Sequential"); }
  void TearDown() override { vtkSMPTools::SetBackend(this->Backend.c_str()); }

  const std::string Backend = vtkSMPTools::GetBackend();
};

TEST_F(MSPFieldProgress, IsFineAndGrows)
{
  for (const int method : { vtkMSPField::SAMPLED, vtkMSPField::ALL_PAIRS })
  {
    std::vector<double> seen;
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(&seen);
    watch->SetCallback([](vtkObject*, unsigned long, void* list, void* fraction)
      { static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(fraction)); });
    vtkNew<vtkMSPField> filter;
    filter->SetInputData(ToPolyData(MakeEgg(4)));
    filter->SetAGDMethod(method);
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    ASSERT_GT(seen.size(), 20u);
    EXPECT_EQ(seen.back(), 1.0);
    for (std::size_t i = 1; i < seen.size(); ++i)
    {
      EXPECT_GE(seen[i], seen[i - 1]);
      EXPECT_LT(seen[i], seen[i - 1] + 0.05) << "AGDMethod " << method;
    }
  }
}

TEST_F(MSPFieldProgress, StopsWhereverItIsAborted)
{
  struct Stop
  {
    double Where;
    double Last = 0.0;
  };
  for (const double where : { -1.0, 0.2, 0.8 })
  {
    Stop stop = { where };
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(&stop);
    watch->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void* fraction)
      {
        auto* client = static_cast<Stop*>(data);
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        if (!algorithm->GetAbortExecute())
        {
          client->Last = *static_cast<double*>(fraction);
          algorithm->SetAbortExecute(client->Last > client->Where ? 1 : 0);
        }
      });
    vtkNew<vtkMSPField> filter;
    filter->SetInputData(ToPolyData(MakeEgg(4)));
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    ErrorObserver errors(filter);
    filter->Update();
    EXPECT_LT(stop.Last, 0.9);
    EXPECT_EQ(errors.Text(), "");
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("MSP"), nullptr) << where;
  }
}
