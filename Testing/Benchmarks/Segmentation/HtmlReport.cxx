// SPDX-License-Identifier: BSD-3-Clause
#include "HtmlReport.h"

#include "SvgPlot.h"

#include <vtkBase64Utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
constexpr const char* Style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #222; background: #fff; margin: 2em auto;
  max-width: 1180px; padding: 0 1em; }
h1, h2 { font-weight: 600; line-height: 1.2; }
h2 { margin-top: 2em; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: 3px 9px; text-align: right; border-bottom: 1px solid #e4e4e4; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
tr.group td { font-weight: 600; } tr.first td { border-top: 2px solid #999; }
.met { color: #14743a; } .missed { color: #b3261e; }
svg { max-width: 100%; height: auto; display: block; }
svg text { font-size: 12px; fill: #333; }
.grid { stroke: #e4e4e4; } .mean { stroke: #1b1b1b; stroke-width: 3; }
.dot { fill: #3b76b8; fill-opacity: 0.45; }
.humans { fill: #fff; stroke: #14743a; stroke-width: 2.5; }
.rigid { fill: #fff; stroke: #b3261e; stroke-width: 2.5; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(480px, 1fr)); gap: 1em; }
figure { margin: 0; } figure img { width: 100%; border: 1px solid #e4e4e4; }
figcaption { font-size: 13px; }
)";

using Columns = std::vector<std::pair<const char*, const char*>>;

std::string Number(double value, int digits = 3)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return std::isnan(value) ? "–" : text.str();
}

bool IsError(const std::string& column)
{
  return column.rfind("rand_error", 0) == 0;
}

/// The number, green or red where the row has a bar for it.
std::string Cell(const SummaryRow& row, const std::string& column, int digits)
{
  const std::string number = Number(row.Value(column), digits);
  const auto bar = row.Bars.find(column);
  if (bar == row.Bars.end() || std::isnan(row.Value(column)))
  {
    return "<td>" + number + "</td>";
  }
  const bool met =
    IsError(column) ? row.Value(column) <= bar->second : row.Value(column) >= bar->second;
  return std::string("<td class=\"") + (met ? "met" : "missed") + "\">" + number +
    (IsError(column) ? " (≤ " : " (≥ ") + Number(bar->second, 2) + ")</td>";
}

std::string Table(const std::vector<SummaryRow>& summary, const Columns& columns, int digits = 3)
{
  std::string html = "<div class=\"scroll\"><table><tr><th></th>";
  for (const auto& [title, column] : columns)
  {
    html += std::string("<th>") + title + "</th>";
  }
  html += "</tr>\n";
  bool inGroups = false;
  for (const SummaryRow& row : summary)
  {
    html +=
      !row.IsGroup ? "<tr>" : (inGroups ? "<tr class=\"group\">" : "<tr class=\"group first\">");
    inGroups = row.IsGroup;
    html += "<td>" + Escaped(row.Name) + "</td>";
    for (const auto& [title, column] : columns)
    {
      html += Cell(row, column, digits);
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string TitleOf(const Result& pair, const std::string& column)
{
  return pair.Category + " " + std::to_string(pair.Source) + " to " + std::to_string(pair.Target) +
    ": " + Number(pair.Value(column));
}

std::string Strips(const std::vector<SummaryRow>& summary, const std::vector<Result>& pairs,
  const std::string& column, const std::string& axis, double largest)
{
  std::vector<PlotStrip> strips;
  for (const SummaryRow& row : summary)
  {
    if (row.IsGroup)
    {
      continue;
    }
    PlotStrip strip{ row.Name, {}, row.Value(column), row.Value("humans_" + column),
      row.Value("rigid_" + column) };
    for (const Result& pair : pairs)
    {
      if (pair.Category == row.Name && !std::isnan(pair.Value(column)))
      {
        strip.Points.push_back({ pair.Value(column), 0.0, TitleOf(pair, column) });
      }
    }
    strips.push_back(strip);
  }
  return StripPlot(axis, strips, largest);
}

std::string Scatter(const std::vector<Result>& pairs, const std::string& x,
  const std::string& xAxis, const std::string& y, const std::string& yAxis)
{
  std::vector<PlotPoint> points;
  for (const Result& pair : pairs)
  {
    points.push_back({ pair.Value(x), pair.Value(y), TitleOf(pair, y) });
  }
  return ScatterPlot(xAxis, yAxis, points);
}

std::string InlinePicture(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string png{ std::istreambuf_iterator<char>(file), {} };
  std::string base64(png.size() * 2 + 4, '\0');
  base64.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(png.data()),
    png.size(), reinterpret_cast<unsigned char*>(&base64[0])));
  return "data:image/png;base64," + base64;
}

std::string Errors(const std::vector<Result>& pairs, const std::vector<Result>& meshes)
{
  std::string html;
  for (const std::vector<Result>* results : { &meshes, &pairs })
  {
    for (const Result& result : *results)
    {
      if (!result.Error.empty())
      {
        html += "<li>" + result.Category + " " + std::to_string(result.Source) +
          (result.Source == result.Target ? "" : " to " + std::to_string(result.Target)) + ": " +
          Escaped(result.Error) + "</li>\n";
      }
    }
  }
  return html.empty() ? "<p>None.</p>\n" : "<ul>\n" + html + "</ul>\n";
}
}

void WriteHtmlReport(const std::string& path, const Method& method,
  const std::vector<SummaryRow>& summary, const std::vector<Result>& pairs,
  const std::vector<Result>& meshes, const std::vector<Picture>& pictures)
{
  std::ofstream html(path);
  html << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
       << "<meta name=\"viewport\" content=\"width=device-width\">\n"
       << "<title>Segmentation transfer, measured</title>\n<style>" << Style
       << "</style>\n</head>\n"
       << "<body>\n<h1>Segmentation transfer, measured</h1>\n<p>" << pairs.size()
       << " ordered pairs of " << meshes.size()
       << " meshes: the pieces of one mesh carried to another of its category, all parameters at "
          "their defaults. Rand error and the other errors are means over the human segmentations "
          "of the target; label accuracy is by area. Rows below the line are means over "
          "categories.</p>\n<p>Method: "
       << method.Name() << ".</p>\n";
  html << "<h2>Segments</h2>\n"
       << Table(summary,
            { { "label accuracy", "label_accuracy" }, { "median", "label_accuracy_median" },
              { "worst", "label_accuracy_worst" }, { "rigid", "rigid_label_accuracy" },
              { "Rand error", "rand_error" }, { "median", "rand_error_median" },
              { "worst", "rand_error_worst" }, { "rigid", "rigid_rand_error" },
              { "humans", "humans_rand_error" }, { "Hamming", "hamming_distance" },
              { "GCE", "gce" }, { "LCE", "lce" }, { "cut discr.", "cut_discrepancy" } });
  html << "<h2>Label accuracy of every pair</h2>\n"
       << Strips(summary, pairs, "label_accuracy", "label accuracy, share of the area", 1.0)
       << "<h2>Rand error of every pair</h2>\n"
       << Strips(summary, pairs, "rand_error", "Rand error, mean over the humans", 0.6);
  html << "<h2>Skeletons</h2>\n"
       << Table(summary,
            { { "nodes inside", "inside_share" }, { "wrong loops", "wrong_loops" },
              { "terminals: recall", "terminal_recall" }, { "precision", "terminal_precision" },
              { "spurs per mesh", "spurs_per_mesh" }, { "field, s", "seconds_field" },
              { "skeleton, s", "seconds_skeleton" } });
  html << "<h2>Correspondences</h2>\n"
       << Table(summary,
            { { "same label: nodes", "same_label_share" },
              { "terminals", "same_label_terminal_share" },
              { "by features: right", "consistent_share" }, { "left/right", "left_right_share" },
              { "front/back", "front_back_share" }, { "coverage", "coverage" },
              { "confidence", "correspondence_confidence" },
              { "matching, s", "seconds_correspondence" }, { "transfer, s", "seconds_transfer" } })
       << "<h2>Confidence and accuracy</h2>\n"
       << Scatter(pairs, "segment_confidence", "mean confidence of the segments", "label_accuracy",
            "label accuracy");
  html << "<h2>Worst pairs</h2>\n";
  if (pictures.empty())
  {
    html << "<p>No pictures: there was no X display to draw them with.</p>\n";
  }
  html << "<div class=\"pictures\">\n";
  for (const auto& [pair, picture] : pictures)
  {
    html << "<figure><img alt=\"\" src=\"" << InlinePicture(picture) << "\"><figcaption>"
         << Escaped(TitleOf(pair, "label_accuracy")) << " label accuracy, "
         << Number(pair.Value("rand_error")) << " Rand error</figcaption></figure>\n";
  }
  html << "</div>\n<h2>Errors</h2>\n" << Errors(pairs, meshes) << "</body>\n</html>\n";
  if (!html)
  {
    throw std::runtime_error(path + ": the file cannot be written.");
  }
}
}
