// SPDX-License-Identifier: BSD-3-Clause
#include "Canvas.h"

#include "Constants.h"
#include "Supersampling.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <cstdio>

namespace figures
{
namespace
{
using marrow::Supersampling;

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}
}

Canvas::Canvas(int width, int height)
  : Width(width)
  , Height(height)
{
  this->Renderer->SetBackground(1, 1, 1);
}

void Canvas::Add(vtkPolyData* shape, const Color& color, double lineWidth)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(Supersampling * lineWidth));
  this->Depth += 0.001;
  actor->SetPosition(0, 0, this->Depth);
  this->Renderer->AddActor(actor);
}

void Canvas::Lines(const std::vector<Point>& points, const Color& color, double width)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(points.size()));
  for (const Point& point : points)
  {
    line->InsertCellPoint(places->InsertNextPoint(point[0], point[1], 0));
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(places);
  shape->SetLines(line);
  this->Add(shape, color, width);
}

void Canvas::Area(const std::vector<Point>& corners, const Color& color)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> polygon;
  polygon->InsertNextCell(static_cast<int>(corners.size()));
  for (const Point& point : corners)
  {
    polygon->InsertCellPoint(places->InsertNextPoint(point[0], point[1], 0));
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(places);
  shape->SetPolys(polygon);
  this->Add(shape, color, 1.0);
}

void Canvas::Disk(const Point& center, double radius, const Color& color)
{
  std::vector<Point> corners;
  for (int i = 0; i < 32; ++i)
  {
    const double angle = 2.0 * marrow::Pi * i / 32;
    corners.push_back(
      { center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle) });
  }
  this->Area(corners, color);
}

void Canvas::Box(const Point& low, const Point& high, const Color& color)
{
  this->Area({ low, { high[0], low[1] }, high, { low[0], high[1] } }, color);
}

void Canvas::Text(const Point& place, const std::string& text, int size, Align align,
  const Color& color, double turn)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetColor(color[0], color[1], color[2]);
  style->SetFontSize(Supersampling * size);
  style->SetOrientation(turn);
  style->SetVerticalJustificationToCentered();
  style->SetJustification(align == Align::Left ? VTK_TEXT_LEFT
      : align == Align::Right                  ? VTK_TEXT_RIGHT
                                               : VTK_TEXT_CENTERED);
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(place[0] / this->Width, place[1] / this->Height);
  this->Renderer->AddViewProp(actor);
}

Picture Canvas::Draw()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.5 * this->Width, 0.5 * this->Height, 0.0);
  camera->SetPosition(0.5 * this->Width, 0.5 * this->Height, 100.0);
  camera->SetParallelScale(0.5 * this->Height);
  camera->SetClippingRange(50.0, 150.0);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(Supersampling * this->Width, Supersampling * this->Height);
  window->AddRenderer(this->Renderer);
  Picture picture = Picture::New();
  marrow::DrawSupersampled(window, picture);
  return picture;
}

Axes::Axes(
  Canvas& canvas, const Point& low, const Point& high, const Point& least, const Point& largest)
  : Sheet(canvas)
  , Low(low)
  , High(high)
  , Least(least)
  , Largest(largest)
{
}

Point Axes::At(double x, double y) const
{
  const double s = (x - this->Least[0]) / (this->Largest[0] - this->Least[0]);
  const double t = (y - this->Least[1]) / (this->Largest[1] - this->Least[1]);
  return { this->Low[0] + s * (this->High[0] - this->Low[0]),
    this->Low[1] + t * (this->High[1] - this->Low[1]) };
}

void Axes::Frame(const std::string& x, const std::string& y)
{
  this->Sheet.Lines(
    { { this->Low[0], this->High[1] }, this->Low, { this->High[0], this->Low[1] } }, Black);
  for (int i = 0; i < 3; ++i)
  {
    const double across = this->Least[0] + 0.5 * i * (this->Largest[0] - this->Least[0]);
    const double up = this->Least[1] + 0.5 * i * (this->Largest[1] - this->Least[1]);
    const Point below = this->At(across, this->Least[1]);
    const Point beside = this->At(this->Least[0], up);
    this->Sheet.Lines({ below, { below[0], below[1] - 4 } }, Black);
    this->Sheet.Lines({ beside, { beside[0] - 4, beside[1] } }, Black);
    this->Sheet.Text({ below[0], below[1] - 13 }, Number(across), 12);
    this->Sheet.Text({ beside[0] - 7, beside[1] }, Number(up), 12, Canvas::Align::Right);
  }
  this->Sheet.Text({ 0.5 * (this->Low[0] + this->High[0]), this->Low[1] - 30 }, x, 13);
  this->Sheet.Text({ this->Low[0] - 42, 0.5 * (this->Low[1] + this->High[1]) }, y, 13,
    Canvas::Align::Center, Black, 90);
}

void Axes::Curve(const std::vector<Point>& values, const Color& color, double width)
{
  std::vector<Point> points;
  for (const Point& value : values)
  {
    points.push_back(this->At(value[0], value[1]));
  }
  this->Sheet.Lines(points, color, width);
}
}
