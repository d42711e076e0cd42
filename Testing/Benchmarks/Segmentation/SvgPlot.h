// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SvgPlot_h
#define marrow_SvgPlot_h

#include <string>
#include <vector>

namespace marrow::bench
{
/// A measured value and what it tells when the mouse is over it.
struct PlotPoint
{
  double X = 0.0;
  double Y = 0.0;
  std::string Title;
};

/// One line of a strip plot: all values of a category, their mean and the peers; NaN is left out.
struct PlotStrip
{
  std::string Name;
  std::vector<PlotPoint> Points; ///< X is drawn
  double Mean = 0.0;
  double Humans = 0.0;
  double Rigid = 0.0;
};

/// Plots as SVG elements, to be put into a page. Axes run from 0 to 1, or for strips to `largest`.
std::string StripPlot(
  const std::string& axis, const std::vector<PlotStrip>& strips, double largest);
std::string ScatterPlot(
  const std::string& xAxis, const std::string& yAxis, const std::vector<PlotPoint>& points);

/// The text with the characters that mean something in HTML and SVG replaced.
std::string Escaped(const std::string& text);
}

#endif
