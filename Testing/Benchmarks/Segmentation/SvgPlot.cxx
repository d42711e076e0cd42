// SPDX-License-Identifier: BSD-3-Clause
#include "SvgPlot.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace marrow::bench
{
namespace
{
constexpr double Left = 120.0;
constexpr double Width = 640.0;
constexpr double RowHeight = 24.0;
constexpr double Top = 34.0;
constexpr double Bottom = 44.0;
constexpr int Ticks = 5;

std::string Circle(double x, double y, double radius, const std::string& title)
{
  std::ostringstream svg;
  svg << "<circle class=\"dot\" cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << radius
      << "\"><title>" << Escaped(title) << "</title></circle>\n";
  return svg.str();
}

std::string Text(double x, double y, const std::string& anchor, const std::string& text)
{
  std::ostringstream svg;
  svg << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">"
      << Escaped(text) << "</text>\n";
  return svg.str();
}

std::string Line(double x1, double y1, double x2, double y2, const std::string& style)
{
  std::ostringstream svg;
  svg << "<line class=\"" << style << "\" x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2
      << "\" y2=\"" << y2 << "\"/>\n";
  return svg.str();
}

std::string Diamond(double x, double y, const std::string& style, const std::string& title)
{
  std::ostringstream svg;
  svg << "<path class=\"" << style << "\" d=\"M" << x - 6 << " " << y << " L" << x << " " << y - 6
      << " L" << x + 6 << " " << y << " L" << x << " " << y + 6 << " Z\"><title>" << Escaped(title)
      << "</title></path>\n";
  return svg.str();
}

std::string Rounded(double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

std::string Opening(double width, double height)
{
  std::ostringstream svg;
  svg << "<svg viewBox=\"0 0 " << width << " " << height << "\" width=\"" << width << "\" height=\""
      << height << "\" role=\"img\">\n";
  return svg.str();
}

std::string Legend(bool humans, bool rigid)
{
  std::string svg = Circle(Left + 8, 14, 3, "") + Text(Left + 18, 18, "start", "a pair") +
    Line(Left + 84, 6, Left + 84, 22, "mean") + Text(Left + 92, 18, "start", "mean");
  if (humans)
  {
    svg += Diamond(Left + 154, 14, "humans", "") +
      Text(Left + 166, 18, "start", "humans among themselves");
  }
  if (rigid)
  {
    svg += Diamond(Left + 354, 14, "rigid", "") +
      Text(Left + 366, 18, "start", "rigid alignment, nearest face");
  }
  return svg;
}
}

std::string StripPlot(const std::string& axis, const std::vector<PlotStrip>& strips, double largest)
{
  const double bottom = Top + RowHeight * strips.size();
  const auto place = [&](double value)
  { return Left + Width * std::min(1.0, std::max(0.0, value / largest)); };
  std::string svg = Opening(Left + Width + 30, bottom + Bottom);
  for (int i = 0; i <= Ticks; ++i)
  {
    const double value = largest * i / Ticks;
    svg += Line(place(value), Top, place(value), bottom, "grid") +
      Text(place(value), bottom + 16, "middle", Rounded(value));
  }
  svg += Text(Left + 0.5 * Width, bottom + 36, "middle", axis);
  bool anyHumans = false;
  bool anyRigid = false;
  for (std::size_t i = 0; i < strips.size(); ++i)
  {
    const PlotStrip& strip = strips[i];
    const double y = Top + RowHeight * (i + 0.5);
    svg += Text(Left - 8, y + 4, "end", strip.Name);
    for (std::size_t k = 0; k < strip.Points.size(); ++k)
    {
      // Spread in three lines, so that equal values show.
      svg += Circle(place(strip.Points[k].X), y + 4.0 * (static_cast<int>(k % 3) - 1), 2.5,
        strip.Points[k].Title);
    }
    if (!std::isnan(strip.Humans))
    {
      svg += Diamond(place(strip.Humans), y, "humans", "humans " + Rounded(strip.Humans));
      anyHumans = true;
    }
    if (!std::isnan(strip.Rigid))
    {
      svg += Diamond(place(strip.Rigid), y, "rigid", "rigid " + Rounded(strip.Rigid));
      anyRigid = true;
    }
    if (!std::isnan(strip.Mean))
    {
      svg += Line(place(strip.Mean), y - 10, place(strip.Mean), y + 10, "mean");
    }
  }
  return svg + Legend(anyHumans, anyRigid) + "</svg>\n";
}

std::string ScatterPlot(
  const std::string& xAxis, const std::string& yAxis, const std::vector<PlotPoint>& points)
{
  constexpr double size = 420.0;
  std::string svg = Opening(Left + size + 30, Top + size + Bottom);
  for (int i = 0; i <= Ticks; ++i)
  {
    const double value = static_cast<double>(i) / Ticks;
    const double x = Left + size * value;
    const double y = Top + size * (1.0 - value);
    svg += Line(x, Top, x, Top + size, "grid") + Line(Left, y, Left + size, y, "grid") +
      Text(x, Top + size + 16, "middle", Rounded(value)) +
      Text(Left - 8, y + 4, "end", Rounded(value));
  }
  for (const PlotPoint& point : points)
  {
    if (!std::isnan(point.X) && !std::isnan(point.Y))
    {
      svg += Circle(Left + size * point.X, Top + size * (1.0 - point.Y), 3, point.Title);
    }
  }
  return svg + Text(Left + 0.5 * size, Top + size + 36, "middle", xAxis) +
    Text(Left, Top - 12, "middle", yAxis) + "</svg>\n";
}

std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}
}
