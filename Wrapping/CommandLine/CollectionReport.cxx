// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionReport.h"

#include "CommandError.h"

#include <vtkBase64Utilities.h>
#include <vtkImageData.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cstdio>
#include <vector>

namespace
{
constexpr const char* Style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #222; background: #fff; margin: 2em auto;
  max-width: 1000px; padding: 0 1em; }
h1 { font-weight: 600; line-height: 1.2; }
figure { margin: 0 0 1.5em; }
figure img { width: 100%; height: auto; border: 1px solid #e4e4e4; }
figcaption { display: flex; gap: 1.5em; flex-wrap: wrap; font-variant-numeric: tabular-nums; }
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

/// The source, the labels and the confidence in a row; the source first, so that the others stand like it.
std::string Picture(const CollectionRow& row, vtkPolyData* source, vtkPolyData* mesh)
{
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(320);
  scene->SetTileHeight(280);
  if (source)
  {
    scene->AddMesh(source, nullptr, ("source: " + row.Source).c_str());
  }
  scene->AddMesh(mesh, nullptr, row.Name.c_str());
  scene->SetSurfaceArray(scene->AddMesh(mesh, nullptr, "confidence"), "SegmentConfidence");
  vtkNew<vtkImageData> image;
  if (!scene->Render(image))
  {
    throw CommandError(row.Name + ": its picture cannot be drawn.");
  }
  return DataAddress(image);
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
      figures += "<figure>\n<img alt=\"" + Escaped(row.Name) + "\" src=\"" +
        Picture(row, meshOf(row.Source), meshOf(row.Name)) + "\">\n<figcaption><b>" +
        Escaped(row.Name) + "</b><span>confidence " + Percent(row.Confidence) +
        "</span><span class=\"note\">" + Escaped(row.Note) + "</span></figcaption>\n</figure>\n";
    }
  }
  return std::string("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<title>Collection</title>\n<style>") +
    Style + "</style>\n</head>\n<body>\n<h1>Collection</h1>\n<p>Labelled: " + sources +
    ". Below are the others, the least sure first: the labelled mesh that each trusted most, its "
    "segments "
    "(equal colours are equal segments), and how sure they are. To correct one, put a segment file "
    "of its "
    "name beside it and run again.</p>\n" +
    failed + figures + "</body>\n</html>\n";
}
