// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Canvas_h
#define marrow_Canvas_h

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

class vtkPolyData;

namespace figures
{
using Picture = vtkSmartPointer<vtkImageData>;
using Color = std::array<double, 3>;
using Point = std::array<double, 2>;

inline constexpr Color Black = { 0.1, 0.1, 0.1 };
inline constexpr Color Grey = { 0.6, 0.6, 0.6 };
inline constexpr Color LightGrey = { 0.85, 0.85, 0.85 };
inline constexpr Color Vermilion = { 0.835, 0.369, 0.0 };
inline constexpr Color Blue = { 0.0, 0.447, 0.698 };
inline constexpr Color Green = { 0.0, 0.62, 0.451 };

/// A drawing of lines, areas and text in pixels, y upwards. What comes later covers what is there.
class Canvas
{
public:
  enum class Align
  {
    Left,
    Center,
    Right
  };

  Canvas(int width, int height);

  void Lines(const std::vector<Point>& points, const Color& color, double width = 1.5);
  void Area(const std::vector<Point>& corners, const Color& color);
  void Disk(const Point& center, double radius, const Color& color);
  void Box(const Point& low, const Point& high, const Color& color);
  /// `place` is the middle of the text's height.
  void Text(const Point& place, const std::string& text, int size = 14, Align align = Align::Center,
    const Color& color = Black, double turn = 0.0);

  Picture Draw();

private:
  void Add(vtkPolyData* shape, const Color& color, double lineWidth);

  int Width;
  int Height;
  double Depth = 0.0;
  vtkNew<vtkRenderer> Renderer;
};

/// A plot's area on a canvas, with its axes.
class Axes
{
public:
  Axes(
    Canvas& canvas, const Point& low, const Point& high, const Point& least, const Point& largest);
  /// The frame, ticks at the ends and in the middle, and the names of both axes.
  void Frame(const std::string& x, const std::string& y);
  Point At(double x, double y) const;
  void Curve(const std::vector<Point>& values, const Color& color, double width = 2.5);

private:
  Canvas& Sheet;
  Point Low, High, Least, Largest;
};
}

#endif
