// SPDX-License-Identifier: BSD-3-Clause
#include "YSkeleton.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkMarrowLabelColors.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkMarrowSkeletonMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <array>
#include <set>

using marrow::test::YSkeleton;

namespace
{
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
  vtkMarrowLabelColors::GetColor(label, rgb);
  return { static_cast<int>(255 * rgb[0]), static_cast<int>(255 * rgb[1]),
    static_cast<int>(255 * rgb[2]) };
}

constexpr std::array<int, 3> DarkGrey = { 63, 63, 63 };

/// The Y in a window of 200 x 200 pixels, one unit of length being 50.
struct MapperScene
{
  MapperScene()
  {
    this->Mapper->SetInputDataObject(YSkeleton());
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(1, 1, 1);
    this->Window->OffScreenRenderingOn();
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(200, 200);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetPosition(0, 0, 10);
    camera->SetParallelScale(2.0);
    camera->SetClippingRange(1, 20);
    this->Window->Render();
  }

  std::array<int, 3> Pixel(int x, int y)
  {
    vtkNew<vtkUnsignedCharArray> pixel;
    this->Window->GetRGBACharPixelData(x, y, x, y, 0, pixel);
    return { pixel->GetValue(0), pixel->GetValue(1), pixel->GetValue(2) };
  }

  vtkNew<vtkMarrowSkeletonMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

bool IsWhite(const std::array<int, 3>& pixel)
{
  return pixel == std::array<int, 3>{ 255, 255, 255 };
}
}

TEST(SkeletonGlyphs, SizesAreFractionsOfTheMeshsDiagonal)
{
  vtkNew<vtkMarrowSkeletonGlyphs> glyphs;
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
  vtkNew<vtkMarrowSkeletonGlyphs> glyphs;
  glyphs->SetInputData(YSkeleton());
  glyphs->Update();
  EXPECT_EQ(ColorsOf(glyphs->GetOutput()).size(), 3u); // branch, terminal, junction
  glyphs->SetColorBy(vtkMarrowSkeletonGlyphs::CORRESPONDENCE);
  glyphs->Update();
  const std::set<std::array<int, 3>> expected = { LabelColor(0), LabelColor(1), LabelColor(2),
    LabelColor(-1) };
  EXPECT_EQ(ColorsOf(glyphs->GetOutput()), expected);
}

TEST(SkeletonGlyphs, AnEmptySkeletonGivesNothing)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkMarrowSkeletonGlyphs> glyphs;
  glyphs->SetInputData(nothing);
  glyphs->Update();
  EXPECT_EQ(glyphs->GetOutput()->GetNumberOfCells(), 0);
}

TEST(SkeletonGlyphs, ColorsTellTheBranchOrTheLabel)
{
  const vtkSmartPointer<vtkPolyData> skeleton = YSkeleton();
  vtkNew<vtkMarrowSkeletonGlyphs> glyphs;
  glyphs->SetInputData(skeleton);
  glyphs->SetColorBy(vtkMarrowSkeletonGlyphs::BRANCH);
  glyphs->Update();
  EXPECT_EQ(ColorsOf(glyphs->GetOutput()).size(), 3u); // no such array: as by node type

  vtkNew<vtkIdTypeArray> branches;
  branches->SetName("BranchId");
  vtkNew<vtkIntArray> labels;
  labels->SetName("Part");
  for (int i = 0; i < 4; ++i)
  {
    labels->InsertNextValue(10 + i / 2);
  }
  for (int i = 0; i < 3; ++i)
  {
    branches->InsertNextValue(5 + i);
  }
  skeleton->GetCellData()->AddArray(branches);
  skeleton->GetPointData()->AddArray(labels);
  skeleton->Modified();
  glyphs->Update();
  using Colors = std::set<std::array<int, 3>>;
  EXPECT_EQ(ColorsOf(glyphs->GetOutput()),
    (Colors{ LabelColor(5), LabelColor(6), LabelColor(7), DarkGrey }));
  glyphs->SetColorBy(vtkMarrowSkeletonGlyphs::LABEL);
  glyphs->SetLabelArrayName("Part");
  glyphs->Update();
  EXPECT_EQ(ColorsOf(glyphs->GetOutput()), (Colors{ LabelColor(10), LabelColor(11) }));
}

TEST(SkeletonGlyphs, ATubeChangesItsColorWhereTheLabelOfTheNodesDoes)
{
  // One branch along x from 0 to 3, its nodes labelled 0, 0, 1, 1.
  vtkNew<vtkPolyData> skeleton;
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> labels;
  labels->SetName("SegmentId");
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i, 0, 0);
    labels->InsertNextValue(i / 2);
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2, 3 });
  skeleton->SetPoints(points);
  skeleton->SetLines(lines);
  skeleton->GetPointData()->AddArray(labels);
  vtkNew<vtkMarrowSkeletonGlyphs> glyphs;
  glyphs->SetInputData(skeleton);
  glyphs->SetColorBy(vtkMarrowSkeletonGlyphs::LABEL);
  glyphs->Update();
  vtkPolyData* tubes = glyphs->GetOutput();
  ASSERT_GT(tubes->GetNumberOfCells(), 0);
  for (vtkIdType cell = 0; cell < tubes->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    tubes->GetCellBounds(cell, bounds);
    if (bounds[0] == bounds[1])
    {
      continue; // a cap
    }
    const double* rgb = tubes->GetCellData()->GetScalars()->GetTuple3(cell);
    const std::array<int, 3> color = { static_cast<int>(rgb[0]), static_cast<int>(rgb[1]),
      static_cast<int>(rgb[2]) };
    EXPECT_EQ(color, LabelColor(bounds[0] + bounds[1] < 4.0 ? 0 : 1)) << bounds[0];
  }
}

TEST(SkeletonGlyphs, RegularNodesHaveBallsOnRequest)
{
  const vtkSmartPointer<vtkPolyData> skeleton = YSkeleton();
  skeleton->GetPointData()->GetArray("NodeType")->SetTuple1(1, 2); // the lowest
  vtkNew<vtkMarrowSkeletonGlyphs> glyphs;
  glyphs->SetInputData(skeleton);
  glyphs->SetBallRadius(0.05);
  glyphs->Update();
  EXPECT_GT(glyphs->GetOutput()->GetBounds()[2], -1.1);
  glyphs->ShowRegularNodesOn();
  glyphs->Update();
  EXPECT_NEAR(glyphs->GetOutput()->GetBounds()[2], -1.35, 0.01); // 0.7 of a feature node's
}

TEST(SkeletonMapper, DrawsTubesAndBalls)
{
  MapperScene scene;
  // The junction in the middle and the terminal one unit below are balls of 6 pixels' radius, the
  // branch between them a tube of 2.5.
  const std::array<int, 3> junction = scene.Pixel(104, 100);
  const std::array<int, 3> terminal = scene.Pixel(104, 50);
  const std::array<int, 3> branch = scene.Pixel(100, 75);
  EXPECT_GT(junction[0], 2 * junction[2]); // vermilion
  EXPECT_GT(terminal[2], 2 * terminal[0]); // blue
  EXPECT_LT(branch[0], 120);
  EXPECT_EQ(branch[0], branch[2]); // grey
  EXPECT_TRUE(IsWhite(scene.Pixel(104, 75)));
  EXPECT_TRUE(IsWhite(scene.Pixel(100, 130)));
}

TEST(SkeletonMapper, FollowsItsGlyphsAndItsInput)
{
  MapperScene scene;
  EXPECT_TRUE(IsWhite(scene.Pixel(104, 75)));
  scene.Mapper->GetGlyphs()->SetTubeRadius(0.02); // 10 pixels
  scene.Window->Render();
  EXPECT_FALSE(IsWhite(scene.Pixel(104, 75)));
  EXPECT_NEAR(scene.Mapper->GetBounds()[5], 0.2, 0.01);

  vtkNew<vtkPolyData> nothing;
  scene.Mapper->SetInputDataObject(nothing);
  scene.Window->Render();
  EXPECT_TRUE(IsWhite(scene.Pixel(100, 75)));
}

TEST(SkeletonMapper, ACellPickerTellsTheBranch)
{
  MapperScene scene;
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.01);
  // The middles of the three branches.
  const int places[3][2] = { { 100, 75 }, { 125, 125 }, { 75, 125 } };
  for (int branch = 0; branch < 3; ++branch)
  {
    ASSERT_EQ(picker->Pick(places[branch][0], places[branch][1], 0, scene.Renderer), 1) << branch;
    EXPECT_EQ(picker->GetActor(), scene.Actor);
    EXPECT_EQ(picker->GetCellId(), branch);
  }
  EXPECT_EQ(picker->Pick(100, 150, 0, scene.Renderer), 0);
}
