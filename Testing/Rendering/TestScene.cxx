// SPDX-License-Identifier: BSD-3-Clause
#include "ImageComparison.h"
#include "RigidAlignment.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkLabelColors.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSideBySideScene.h>
#include <vtkSkeletonGlyphs.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>

#include <Eigen/Geometry>

#include <set>

namespace
{
vtkSmartPointer<vtkPolyData> Creature(int shape = vtkCreatureSource::QUADRUPED)
{
  vtkNew<vtkCreatureSource> creature;
  creature->SetShape(shape);
  creature->SetResolution(2500);
  creature->Update();
  return creature->GetOutput();
}

vtkSmartPointer<vtkPolyData> Transformed(vtkPolyData* mesh, vtkTransform* transform)
{
  vtkNew<vtkTransformFilter> filter;
  filter->SetInputData(mesh);
  filter->SetTransform(transform);
  filter->Update();
  return filter->GetPolyDataOutput();
}

void Draw(vtkSideBySideScene* scene, vtkImageData* image)
{
  scene->SetTileWidth(120);
  scene->SetTileHeight(100);
  ASSERT_TRUE(scene->Render(image));
}

/// The picture of the tile at the right of two.
vtkSmartPointer<vtkImageData> SecondTile(vtkPolyData* first, vtkPolyData* second, bool align)
{
  vtkNew<vtkSideBySideScene> scene;
  scene->AddMesh(first);
  scene->AddMesh(second);
  scene->SetAlign(align);
  vtkNew<vtkImageData> both;
  Draw(scene, both);
  auto tile = vtkSmartPointer<vtkImageData>::New();
  tile->SetDimensions(120, 100, 1);
  tile->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 100; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      for (int k = 0; k < 3; ++k)
      {
        tile->SetScalarComponentFromDouble(
          x, y, 0, k, both->GetScalarComponentAsDouble(120 + x, y, 0, k));
      }
    }
  }
  return tile;
}

/// A Y of four points: a junction and three terminals, in a mesh of diagonal 10.
vtkSmartPointer<vtkPolyData> YSkeleton()
{
  auto skeleton = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(0, -1, 0);
  points->InsertNextPoint(1, 1, 0);
  points->InsertNextPoint(-1, 1, 0);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> types;
  types->SetName("NodeType");
  types->InsertNextValue(3);
  vtkNew<vtkIdTypeArray> nodeIds;
  nodeIds->SetName("CorrespondenceId");
  nodeIds->InsertNextValue(0);
  vtkNew<vtkIdTypeArray> branchIds;
  branchIds->SetName("BranchCorrespondenceId");
  for (int i = 1; i < 4; ++i)
  {
    lines->InsertNextCell({ 0, i });
    types->InsertNextValue(1);
    nodeIds->InsertNextValue(i < 3 ? i : -1);
    branchIds->InsertNextValue(i < 3 ? i : -1);
  }
  skeleton->SetPoints(points);
  skeleton->SetLines(lines);
  skeleton->GetPointData()->AddArray(types);
  skeleton->GetPointData()->AddArray(nodeIds);
  skeleton->GetCellData()->AddArray(branchIds);
  vtkNew<vtkDoubleArray> diagonal;
  diagonal->SetName("MeshDiagonal");
  diagonal->InsertNextValue(10.0);
  skeleton->GetFieldData()->AddArray(diagonal);
  return skeleton;
}

std::set<std::array<int, 3>> ColorsOf(vtkPolyData* glyphs)
{
  std::set<std::array<int, 3>> colors;
  vtkDataArray* array = glyphs->GetCellData()->GetScalars();
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    const double* rgb = array->GetTuple3(i);
    colors.insert({ static_cast<int>(rgb[0]), static_cast<int>(rgb[1]), static_cast<int>(rgb[2]) });
  }
  return colors;
}

std::array<int, 3> LabelColor(vtkIdType label)
{
  double rgb[3];
  vtkLabelColors::GetColor(label, rgb);
  return { static_cast<int>(255 * rgb[0]), static_cast<int>(255 * rgb[1]),
    static_cast<int>(255 * rgb[2]) };
}
}

TEST(LabelColors, TwentyFourLabelsAndNoneDiffer)
{
  std::set<std::array<int, 3>> colors;
  for (vtkIdType label = -1; label < 24; ++label)
  {
    colors.insert(LabelColor(label));
  }
  EXPECT_EQ(colors.size(), 25u);
  EXPECT_EQ(LabelColor(24), LabelColor(0));
  EXPECT_EQ(LabelColor(-1), LabelColor(-7));
}

TEST(LabelColors, ColorOfALabelDoesNotDependOnTheOthers)
{
  vtkNew<vtkIntArray> few;
  vtkNew<vtkIntArray> many;
  for (int label : { 7, 3 })
  {
    few->InsertNextValue(label);
  }
  for (int label : { 0, 1, -1, 3, 11, 7, 130 })
  {
    many->InsertNextValue(label);
  }
  vtkNew<vtkLookupTable> fewColors;
  vtkLabelColors::FillLookupTable(fewColors, few);
  vtkNew<vtkLookupTable> manyColors;
  vtkLabelColors::FillLookupTable(manyColors, many);
  for (int label : { 3, 7 })
  {
    double a[4];
    double b[4];
    double expected[3];
    fewColors->GetAnnotationColor(vtkVariant(label), a);
    manyColors->GetAnnotationColor(vtkVariant(label), b);
    vtkLabelColors::GetColor(label, expected);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(a[k], expected[k], 1.0 / 255);
      EXPECT_EQ(a[k], b[k]);
    }
  }
}

TEST(SkeletonGlyphs, SizesAreFractionsOfTheMeshsDiagonal)
{
  vtkNew<vtkSkeletonGlyphs> glyphs;
  glyphs->SetInputData(YSkeleton());
  glyphs->SetBallRadius(0.05);
  glyphs->SetTubeRadius(0.01);
  glyphs->Update();
  // The lowest terminal at y = -1 with a ball of 0.05 x 10.
  EXPECT_NEAR(glyphs->GetOutput()->GetBounds()[2], -1.5, 0.01);
  EXPECT_NEAR(glyphs->GetOutput()->GetBounds()[1], 1.5, 0.02);
}

TEST(SkeletonGlyphs, ColorsTellTheNodeTypeOrTheCorrespondence)
{
  vtkNew<vtkSkeletonGlyphs> glyphs;
  glyphs->SetInputData(YSkeleton());
  glyphs->Update();
  EXPECT_EQ(ColorsOf(glyphs->GetOutput()).size(), 3u); // branch, terminal, junction
  glyphs->SetColorBy(vtkSkeletonGlyphs::CORRESPONDENCE);
  glyphs->Update();
  const std::set<std::array<int, 3>> expected = { LabelColor(0), LabelColor(1), LabelColor(2),
    LabelColor(-1) };
  EXPECT_EQ(ColorsOf(glyphs->GetOutput()), expected);
}

TEST(SkeletonGlyphs, AnEmptySkeletonGivesNothing)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkSkeletonGlyphs> glyphs;
  glyphs->SetInputData(nothing);
  glyphs->Update();
  EXPECT_EQ(glyphs->GetOutput()->GetNumberOfCells(), 0);
}

TEST(RigidAlignment, FindsTheRotationAndNeverAReflection)
{
  const marrow::LabelCentroids reference = { { 1, { 0, 0, 0 } }, { 2, { 1, 0, 0 } },
    { 3, { 0, 2, 0 } }, { 5, { 0, 0, 3 } } };
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  marrow::LabelCentroids turned = { { 9, { 100, 0, 0 } } }; // shared by nobody
  marrow::LabelCentroids mirrored;
  for (const auto& [label, centroid] : reference)
  {
    turned[label] = 4.0 * (rotation * centroid) + Eigen::Vector3d(5, 6, 7);
    mirrored[label] = Eigen::Vector3d(-centroid.x(), centroid.y(), centroid.z());
  }
  EXPECT_TRUE(marrow::RotationTo(reference, turned).isApprox(rotation.transpose(), 1e-12));
  EXPECT_NEAR(marrow::RotationTo(reference, mirrored).determinant(), 1.0, 1e-12);
  const marrow::LabelCentroids two = { { 1, { 0, 0, 0 } }, { 2, { 0, 1, 0 } } };
  EXPECT_TRUE(marrow::RotationTo(reference, two).isIdentity());
}

TEST(RigidAlignment, TheBroadSideIsPerpendicularToUpAndToTheLongAxis)
{
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 100; ++i)
  {
    points.emplace_back(0.1 * (i % 3), 0.5 * (i % 7), 0.2 * i);
  }
  EXPECT_GT(marrow::BroadSide(points, Eigen::Vector3d::UnitY()).x(), 0.999);
}

TEST(SideBySideScene, AnAlignedCopyLooksLikeTheOriginal)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature();
  vtkNew<vtkTransform> transform;
  transform->Scale(1000, 1000, 1000);
  transform->RotateX(100);
  transform->RotateY(-50);
  transform->Translate(3, 4, 5);
  const vtkSmartPointer<vtkPolyData> turned = Transformed(mesh, transform);
  const vtkSmartPointer<vtkImageData> original = SecondTile(mesh, mesh, true);
  EXPECT_LT(marrow::test::ImageError(SecondTile(mesh, turned, true), original), 20.0);
  EXPECT_GT(marrow::test::ImageError(SecondTile(mesh, turned, false), original), 500.0);
}

TEST(SideBySideScene, TheSkeletonShowsThroughATransparentSurface)
{
  vtkNew<vtkCreatureSource> creature;
  creature->SetResolution(2500);
  creature->Update();
  vtkNew<vtkImageData> images[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkSideBySideScene> scene;
    scene->SetSurfaceOpacity(0.3);
    scene->AddMesh(creature->GetOutput(), i == 0 ? nullptr : creature->GetOutput(1));
    Draw(scene, images[i]);
  }
  EXPECT_GT(marrow::test::ImageError(images[0], images[1]), 100.0);
}

TEST(SideBySideScene, ErrorsAreTold)
{
  std::string told;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&told);
  listen->SetCallback([](vtkObject*, unsigned long, void* text, void* error)
    { *static_cast<std::string*>(text) = static_cast<const char*>(error); });
  vtkNew<vtkImageData> image;

  vtkNew<vtkSideBySideScene> scene;
  scene->AddObserver(vtkCommand::ErrorEvent, listen);
  EXPECT_FALSE(scene->Render(image));
  EXPECT_NE(told.find("The scene has no mesh"), std::string::npos) << told;

  scene->AddMesh(nullptr);
  EXPECT_NE(told.find("A tile needs a mesh"), std::string::npos) << told;

  scene->AddMesh(Creature());
  scene->SetViewDirection(0, 2, 0);
  EXPECT_FALSE(scene->Render(image));
  EXPECT_NE(told.find("parallel"), std::string::npos) << told;

  scene->SetViewDirection(0, 0, 1);
  EXPECT_FALSE(scene->WritePNG("/absent/folder/picture.png"));
  EXPECT_NE(told.find("cannot be written"), std::string::npos) << told;
}
