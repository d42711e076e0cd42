// SPDX-License-Identifier: BSD-3-Clause
#include "ImageComparison.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMarrowLabelColors.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

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

void Draw(vtkMarrowSideBySideScene* scene, vtkImageData* image)
{
  scene->SetTileWidth(120);
  scene->SetTileHeight(100);
  ASSERT_TRUE(scene->Render(image));
}

/// The picture of the tile at the right of two.
vtkSmartPointer<vtkImageData> SecondTile(vtkPolyData* first, vtkPolyData* second, bool align)
{
  vtkNew<vtkMarrowSideBySideScene> scene;
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

/// Pixels of the hue and saturation of `rgb`, however they are lit.
int CountPixels(vtkImageData* image, const Eigen::Vector3d& rgb, int x0, int x1, int y0, int y1)
{
  int count = 0;
  for (int y = y0; y < y1; ++y)
  {
    for (int x = x0; x < x1; ++x)
    {
      Eigen::Vector3d pixel;
      for (int k = 0; k < 3; ++k)
      {
        pixel[k] = image->GetScalarComponentAsDouble(x, y, 0, k);
      }
      const double brightness = pixel.maxCoeff();
      const Eigen::Vector3d difference = pixel / brightness - rgb / rgb.maxCoeff();
      count += brightness > 40 && difference.cwiseAbs().maxCoeff() < 0.15 ? 1 : 0;
    }
  }
  return count;
}

/// A unit square across z.
vtkSmartPointer<vtkPolyData> Square()
{
  vtkNew<vtkPlaneSource> square;
  square->Update();
  return square->GetOutput();
}

/// Two nodes in front of it, at the left and at the right, with their heights and ids.
vtkSmartPointer<vtkPolyData> TwoNodes(double left, double right, int leftId, int rightId)
{
  auto skeleton = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-0.3, left, 0.1);
  points->InsertNextPoint(0.3, right, 0.1);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("CorrespondenceId");
  ids->InsertNextValue(leftId);
  ids->InsertNextValue(rightId);
  skeleton->SetPoints(points);
  skeleton->GetPointData()->AddArray(ids);
  return skeleton;
}

void LookFromTheFront(vtkMarrowSideBySideScene* scene)
{
  scene->SetViewDirection(0, 0, 1);
  scene->SetAzimuth(0);
  scene->SetElevation(0);
}
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
    vtkNew<vtkMarrowSideBySideScene> scene;
    scene->SetSurfaceOpacity(0.3);
    scene->AddMesh(creature->GetOutput(), i == 0 ? nullptr : creature->GetOutput(1));
    Draw(scene, images[i]);
  }
  EXPECT_GT(marrow::test::ImageError(images[0], images[1]), 100.0);
}

TEST(SideBySideScene, LinksRunBetweenNodesOfEqualId)
{
  Eigen::Vector3d one;
  vtkMarrowLabelColors::GetColor(1, one.data());
  for (const bool show : { false, true })
  {
    vtkNew<vtkMarrowSideBySideScene> scene;
    LookFromTheFront(scene);
    // Only the second node of the one and the first of the other are matched: a line of label 1 from
    // the right half of the first tile to the left half of the second, at one height.
    scene->AddMesh(Square(), TwoNodes(0.0, 0.25, -1, 1));
    scene->AddMesh(Square(), TwoNodes(0.25, 0.0, 1, 2));
    scene->SetShowLinks(show);
    scene->SetSurfaceOpacity(0.0);
    vtkNew<vtkImageData> image;
    Draw(scene, image);
    // A unit is 100 / 1.05 pixels, the height 50 + 0.25 of that.
    const int height = 73;
    EXPECT_EQ(CountPixels(image, one, 120 - 25, 120 + 25, height - 2, height + 3) >= 50, show);
    EXPECT_EQ(CountPixels(image, one, 0, 240, 0, height - 4), 0);
    EXPECT_EQ(CountPixels(image, one, 0, 80, 0, 100), 0);
  }
}

TEST(SideBySideScene, AMeasureColorsTheSurfaceAndHasAScalarBar)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(mesh->GetPoint(i)[1] - mesh->GetBounds()[2]);
  }
  mesh->GetPointData()->AddArray(height);
  vtkNew<vtkDoubleArray> doubled;
  doubled->DeepCopy(height);
  for (vtkIdType i = 0; i < doubled->GetNumberOfTuples(); ++i)
  {
    doubled->SetValue(i, 3.0 * doubled->GetValue(i));
  }
  vtkNew<vtkPolyData> taller;
  taller->ShallowCopy(mesh);
  doubled->SetName("Height");
  taller->GetPointData()->AddArray(doubled);

  vtkNew<vtkImageData> images[2];
  for (int shared = 0; shared < 2; ++shared)
  {
    vtkNew<vtkMarrowSideBySideScene> scene;
    scene->SetShareRange(shared == 1);
    scene->SetSurfaceArray(scene->AddMesh(mesh), "Height");
    scene->SetSurfaceArray(scene->AddMesh(taller), "Height");
    Draw(scene, images[shared]);
  }
  vtkNew<vtkMarrowSideBySideScene> given;
  given->SetSurfaceArray(given->AddMesh(mesh), "Height");
  given->SetSurfaceRange(0, 0.0, 2.0 * height->GetRange()[1]);
  vtkNew<vtkImageData> ofGiven;
  Draw(given, ofGiven);
  // Feet dark blue, head bright: viridis runs upwards, above the scalar bar's 17 lowest rows.
  const Eigen::Vector3d dark(68, 1, 84);
  const Eigen::Vector3d bright(253, 231, 37);
  EXPECT_GT(CountPixels(images[0], dark, 0, 120, 17, 50), 20);
  EXPECT_EQ(CountPixels(images[0], bright, 0, 120, 17, 50), 0);
  EXPECT_GT(CountPixels(images[0], bright, 0, 120, 50, 100), 20);
  // The scalar bar holds both ends.
  EXPECT_GT(CountPixels(images[0], dark, 0, 60, 0, 17), 5);
  EXPECT_GT(CountPixels(images[0], bright, 60, 120, 0, 17), 5);
  // With one range for both, the one of small values has nothing bright any more.
  EXPECT_EQ(CountPixels(images[1], bright, 0, 120, 50, 100), 0);
  EXPECT_GT(CountPixels(images[1], bright, 120, 240, 50, 100), 20);
  // Nor with one that ends at twice its height.
  EXPECT_GT(CountPixels(ofGiven, dark, 0, 120, 17, 50), 20);
  EXPECT_EQ(CountPixels(ofGiven, bright, 0, 120, 50, 100), 0);
}

TEST(SideBySideScene, OtherLabelsColorTheSurfaceAndDoNotTurnIt)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature();
  vtkDataArray* labels = mesh->GetCellData()->GetArray("SegmentId");
  vtkNew<vtkPolyData> otherwise;
  otherwise->ShallowCopy(mesh);
  // Head for tail and tail for head, which would turn it round.
  vtkNew<vtkIntArray> exchanged;
  exchanged->SetName("Exchanged");
  const int most = static_cast<int>(labels->GetRange()[1]);
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    exchanged->InsertNextValue(most - static_cast<int>(labels->GetTuple1(i)));
  }
  otherwise->GetCellData()->AddArray(exchanged);
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->AddMesh(mesh);
  scene->SetSurfaceLabels(scene->AddMesh(otherwise), "Exchanged");
  vtkNew<vtkImageData> image;
  Draw(scene, image);
  int ofOneOnly = 0;
  int ofOtherColor = 0;
  for (int y = 0; y < 100; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      double here = 0.0;
      double there = 0.0;
      double difference = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double first = image->GetScalarComponentAsDouble(x, y, 0, k);
        const double second = image->GetScalarComponentAsDouble(120 + x, y, 0, k);
        here = std::max(here, 255.0 - first);
        there = std::max(there, 255.0 - second);
        difference = std::max(difference, std::abs(first - second));
      }
      ofOneOnly += (here == 0.0) != (there == 0.0) ? 1 : 0;
      ofOtherColor += difference > 30.0 ? 1 : 0;
    }
  }
  EXPECT_EQ(ofOneOnly, 0);
  EXPECT_GT(ofOtherColor, 500);
}

TEST(SideBySideScene, SkeletonsTakeTheLabelsOfTheirPartOfTheSurface)
{
  vtkNew<vtkCreatureSource> creature;
  creature->SetResolution(2500);
  creature->Update();
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetSurfaceOpacity(0.0);
  scene->SetColorSkeletonBy(vtkMarrowSkeletonGlyphs::LABEL);
  scene->AddMesh(creature->GetOutput(0), creature->GetOutput(1));
  vtkNew<vtkImageData> image;
  Draw(scene, image);
  for (vtkIdType label = 0; label < 8; ++label)
  {
    Eigen::Vector3d rgb;
    vtkMarrowLabelColors::GetColor(label, rgb.data());
    EXPECT_GT(CountPixels(image, rgb, 0, 120, 0, 100), 3) << "label " << label;
  }
}

TEST(SideBySideScene, MatchedSkeletonsAlignWhereThereAreNoLabels)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature();
  mesh->GetCellData()->RemoveArray("SegmentId");
  vtkNew<vtkPolyData> skeleton;
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("CorrespondenceId");
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint(i == 0, 2 * (i == 1), 0);
    ids->InsertNextValue(i);
  }
  skeleton->SetPoints(points);
  skeleton->GetPointData()->AddArray(ids);
  vtkNew<vtkTransform> transform;
  transform->RotateX(100);
  transform->RotateY(-50);
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->AddMesh(mesh, skeleton);
  scene->AddMesh(mesh, skeleton);
  vtkNew<vtkImageData> expected;
  Draw(scene, expected);
  vtkNew<vtkMarrowSideBySideScene> turned;
  turned->AddMesh(mesh, skeleton);
  turned->AddMesh(Transformed(mesh, transform), Transformed(skeleton, transform));
  vtkNew<vtkImageData> image;
  Draw(turned, image);
  EXPECT_LT(marrow::test::ImageError(image, expected), 20.0);
}

TEST(SideBySideScene, CurvesAndActorsStandOnTheirTileAndACloseUpFillsIt)
{
  // A line and a ball on the second of two squares.
  const vtkSmartPointer<vtkPolyData> square = Square();
  vtkNew<vtkPoints> line;
  line->InsertNextPoint(-0.5, 0.3, 0.02);
  line->InsertNextPoint(0.5, 0.3, 0.02);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> curve;
  curve->SetPoints(line);
  curve->SetLines(cells);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0, -0.3, 0.02);
  ball->SetRadius(0.05);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0, 0, 1);

  vtkNew<vtkMarrowSideBySideScene> scene;
  LookFromTheFront(scene);
  scene->AddMesh(square);
  const int second = scene->AddMesh(square);
  scene->AddCurves(second, curve, 1.0, 0.0, 0.0, 0.02);
  scene->AddActor(second, actor);
  vtkNew<vtkImageData> image;
  Draw(scene, image);
  const auto count = [&](int component, int x0, int x1, int y0, int y1)
  {
    int pixels = 0;
    for (int y = y0; y < y1; ++y)
    {
      for (int x = x0; x < x1; ++x)
      {
        const double other = image->GetScalarComponentAsDouble(x, y, 0, 1);
        pixels += image->GetScalarComponentAsDouble(x, y, 0, component) > 2 * other + 20 ? 1 : 0;
      }
    }
    return pixels;
  };
  EXPECT_EQ(count(0, 0, 120, 0, 100), 0);
  EXPECT_GT(count(0, 120, 240, 72, 84), 150); // 0.3 above the middle
  EXPECT_EQ(count(0, 120, 240, 0, 70), 0);
  EXPECT_GT(count(2, 120, 240, 12, 32), 40); // 0.3 below the middle
  EXPECT_EQ(count(2, 120, 240, 50, 100), 0);

  // With the ball alone in view it fills its tile.
  ball->Update();
  scene->SetCloseUp(second, ball->GetOutput());
  Draw(scene, image);
  EXPECT_GT(count(2, 120, 240, 0, 100), 3000);
}

TEST(SideBySideScene, CanBeShownInAWindowOfOnesOwn)
{
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(120);
  scene->SetTileHeight(100);
  scene->AddMesh(Creature());
  scene->AddMesh(Creature(vtkCreatureSource::BIPED));
  EXPECT_EQ(scene->GetRenderer(0), nullptr);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  ASSERT_TRUE(scene->AddTo(window));
  EXPECT_EQ(window->GetSize()[0], 240);
  EXPECT_EQ(window->GetSize()[1], 100);
  ASSERT_NE(scene->GetRenderer(1), nullptr);
  EXPECT_EQ(scene->GetRenderer(1)->GetRenderWindow(), window);
  EXPECT_EQ(scene->GetRenderer(2), nullptr);
}

TEST(SideBySideScene, ATransparentSurfaceShowsInAnyWindow)
{
  // A window multisamples unless told otherwise, and VTK leaves out what it should peel then.
  for (const bool drawnBefore : { false, true })
  {
    vtkNew<vtkMarrowSideBySideScene> scene;
    LookFromTheFront(scene);
    scene->SetTileWidth(120);
    scene->SetTileHeight(100);
    scene->SetTileOpacity(scene->AddMesh(Square()), 0.5);
    vtkNew<vtkRenderWindow> window;
    window->OffScreenRenderingOn();
    window->SetMultiSamples(8);
    if (drawnBefore)
    {
      window->Render();
    }
    ASSERT_TRUE(scene->AddTo(window));
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixel;
    window->GetRGBACharPixelData(60, 50, 60, 50, 0, pixel);
    // Light blue on white, the one half of the other.
    EXPECT_LT(pixel->GetValue(0), 245) << drawnBefore;
    EXPECT_GT(pixel->GetValue(0), 128) << drawnBefore;
  }
}

TEST(SideBySideScene, ErrorsAreTold)
{
  std::string told;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&told);
  listen->SetCallback([](vtkObject*, unsigned long, void* text, void* error)
    { *static_cast<std::string*>(text) = static_cast<const char*>(error); });
  vtkNew<vtkImageData> image;

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->AddObserver(vtkCommand::ErrorEvent, listen);
  EXPECT_FALSE(scene->Render(image));
  EXPECT_NE(told.find("The scene has no mesh"), std::string::npos) << told;

  EXPECT_EQ(scene->AddMesh(nullptr), -1);
  EXPECT_NE(told.find("A tile needs a mesh"), std::string::npos) << told;

  EXPECT_EQ(scene->AddMesh(Creature()), 0);
  scene->SetTileOpacity(1, 0.5);
  EXPECT_NE(told.find("There is no tile 1"), std::string::npos) << told;
  scene->SetSurfaceArray(0, "Absent");
  EXPECT_NE(told.find("neither a point nor a cell array Absent"), std::string::npos) << told;
  scene->SetSurfaceLabels(0, "Elsewhere");
  EXPECT_NE(told.find("no cell array Elsewhere"), std::string::npos) << told;

  scene->SetViewDirection(0, 2, 0);
  EXPECT_FALSE(scene->Render(image));
  EXPECT_NE(told.find("parallel"), std::string::npos) << told;

  scene->SetViewDirection(0, 0, 1);
  EXPECT_FALSE(scene->WritePNG("/absent/folder/picture.png"));
  EXPECT_NE(told.find("cannot be written"), std::string::npos) << told;
}
