// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionReport.h"

#include "CommandError.h"

#include <vtkBase64Utilities.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace
{
/// Pixels. Six fit beside each other on a usual screen.
constexpr int TileWidth = 240;
constexpr int TileHeight = 200;

constexpr const char* Style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #222; background: #fff; margin: 1.5em auto;
  max-width: 1440px; padding: 0 1em; }
h1 { font-weight: 600; line-height: 1.2; }
p { max-width: 50em; }
figure { margin: 0; padding: 0.5em 0 0.8em; border-top: 1px solid #d8d8d8; }
figure img { height: auto; display: block; }
figcaption { display: flex; gap: 0.2em 1.5em; flex-wrap: wrap; font-variant-numeric: tabular-nums; }
figcaption b { min-width: 8em; }
.note { color: #8a4b00; }
.failed { color: #b3261e; }
)";

std::string Escaped(const std::string& text)
{
  std::string html;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string Decimal(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", value);
  return text;
}

std::string Percent(double share)
{
  char text[16];
  std::snprintf(text, sizeof(text), "%.0f %%", 100.0 * share);
  return text;
}

/// An image as the content of a page.
std::string DataAddress(vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  const auto size = static_cast<unsigned long>(png->GetNumberOfValues());
  std::vector<unsigned char> text(2 * size + 4);
  const unsigned long length = vtkBase64Utilities::Encode(png->GetPointer(0), size, text.data());
  return "data:image/png;base64," + std::string(text.begin(), text.begin() + length);
}

/// The mesh with a cell array of labels for each answer that it did not take.
struct RejectedAnswers
{
  vtkNew<vtkPolyData> Mesh;
  std::vector<std::string> Arrays;
  std::vector<std::string> Captions;
};

void FillRejected(vtkPolyData* mesh, RejectedAnswers& rejected)
{
  rejected.Mesh->ShallowCopy(mesh);
  vtkDataArray* labels = mesh->GetCellData()->GetArray("RejectedSegmentId");
  vtkDataArray* against = mesh->GetFieldData()->GetArray("RejectedAgainst");
  vtkDataArray* difference = mesh->GetFieldData()->GetArray("RejectedDifference");
  if (!labels || !against || !difference)
  {
    return; // Every other answer is like the one taken.
  }
  for (int i = 0; i < labels->GetNumberOfComponents(); ++i)
  {
    vtkNew<vtkIntArray> ofAnswer;
    ofAnswer->SetName(("rejected " + std::to_string(i)).c_str());
    ofAnswer->SetNumberOfTuples(labels->GetNumberOfTuples());
    ofAnswer->CopyComponent(0, labels, i);
    rejected.Mesh->GetCellData()->AddArray(ofAnswer);
    rejected.Arrays.emplace_back(ofAnswer->GetName());
    rejected.Captions.push_back("rejected: " + Decimal(against->GetTuple1(i)) + ", " +
      Percent(difference->GetTuple1(i)) + " otherwise");
  }
}

/// Hands and planes lie in their files; from their side, as a standing animal is seen, one would see little.
void LookFromAboveIfFlat(vtkPolyData* mesh, vtkMarrowSideBySideScene* scene)
{
  double center[3];
  mesh->GetCenter(center);
  double spread[3][3] = {};
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    vtkMath::Subtract(point, center, point);
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        spread[row][column] += point[row] * point[column];
      }
    }
  }
  double along[3];
  double axes[3][3]; // in columns
  vtkMath::Diagonalize3x3(spread, along, axes);
  const auto least = std::min_element(along, along + 3) - along;
  const auto most = std::max_element(along, along + 3) - along;
  constexpr double nearerToUp = 0.7; // than to the ground
  if (std::abs(axes[1][least]) > nearerToUp)
  {
    const double sign = axes[1][least] > 0.0 ? 1.0 : -1.0;
    scene->SetViewDirection(sign * axes[0][least], sign * axes[1][least], sign * axes[2][least]);
    scene->SetViewUp(axes[0][most], axes[1][most], axes[2][most]);
  }
}

/// In one row the source, the labels, the confidence, and the answers that were not taken. The source is the
/// first, so that the others stand like it.
std::string Picture(const CollectionRow& row, vtkPolyData* source, vtkPolyData* mesh)
{
  RejectedAnswers rejected;
  FillRejected(mesh, rejected);
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(TileWidth);
  scene->SetTileHeight(TileHeight);
  if (source)
  {
    LookFromAboveIfFlat(source, scene);
    scene->AddMesh(source, nullptr, ("source: " + row.Source).c_str());
  }
  scene->AddMesh(mesh, nullptr, row.Name.c_str());
  int last = scene->AddMesh(mesh, nullptr, "confidence");
  scene->SetSurfaceArray(last, "SegmentConfidence");
  scene->SetSurfaceRange(last, 0.0, 1.0); // so that rows can be compared
  for (std::size_t i = 0; i < rejected.Arrays.size(); ++i)
  {
    last = scene->AddMesh(rejected.Mesh, nullptr, rejected.Captions[i].c_str());
    scene->SetSurfaceLabels(last, rejected.Arrays[i].c_str());
  }
  vtkNew<vtkImageData> image;
  if (!scene->Render(image))
  {
    throw CommandError(row.Name + ": its picture cannot be drawn.");
  }
  // A tile is as wide in every row.
  constexpr int most = 3 + MostRejectedAnswers;
  return "<img alt=\"" + Escaped(row.Name) +
    "\" style=\"width: " + std::to_string(100.0 * (last + 1) / most) + "%\" src=\"" +
    DataAddress(image) + "\">";
}
}

std::string CollectionReport(
  const std::vector<CollectionRow>& rows, const std::map<std::string, vtkPolyData*>& meshOfName)
{
  const auto meshOf = [&](const std::string& name)
  {
    const auto found = meshOfName.find(name);
    return found == meshOfName.end() ? nullptr : found->second;
  };
  std::string sources;
  std::string figures;
  std::string failed;
  for (const CollectionRow& row : LeastSureFirst(rows))
  {
    if (row.Role == "source")
    {
      sources += (sources.empty() ? "" : ", ") + Escaped(row.Name);
    }
    else if (row.Role == "failed")
    {
      failed += "<p class=\"failed\">" + Escaped(row.Name) + ": " + Escaped(row.Note) + "</p>\n";
    }
    else
    {
      figures += "<figure>\n<figcaption><b>" + Escaped(row.Name) + "</b><span>confidence " +
        Percent(row.Confidence) + "</span><span>against " + Decimal(row.Against) +
        "</span><span class=\"note\">" + Escaped(row.Note) + "</span></figcaption>\n" +
        Picture(row, meshOf(row.Source), meshOf(row.Name)) + "\n</figure>\n";
    }
  }
  return std::string("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<title>Collection</title>\n<style>") +
    Style + "</style>\n</head>\n<body>\n<h1>Collection</h1>\n<p>Labelled: " + sources +
    ". Below are the others, the least sure first. In a row: the labelled mesh that each trusted "
    "most; its segments (equal colours are equal segments); how sure they are; and up to three "
    "answers that it "
    "rejected: how that labelled mesh would label it if the parts corresponded otherwise. "
    "<i>Against</i> is all "
    "that speaks against an answer; good ones are below 1. With each rejected one stand the same "
    "and "
    "how much of the surface it would label otherwise.</p>\n<p>To correct a mesh, put a segment "
    "file "
    "of its name beside it and run again.</p>\n" +
    failed + figures + "</body>\n</html>\n";
}
