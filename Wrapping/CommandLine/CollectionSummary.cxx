// SPDX-License-Identifier: BSD-3-Clause
#include "CollectionSummary.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <tuple>

namespace
{
std::map<int, double> AreaOfLabels(vtkPolyData* mesh)
{
  std::map<int, double> areas;
  vtkDataArray* labels = mesh->GetCellData()->GetArray("SegmentId");
  double total = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; labels && cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    if (corners->GetNumberOfIds() < 3)
    {
      continue;
    }
    double normal[3];
    const double area = vtkPolygon::ComputeArea(
      mesh->GetPoints(), corners->GetNumberOfIds(), corners->GetPointer(0), normal);
    areas[static_cast<int>(labels->GetTuple1(cell))] += area;
    total += area;
  }
  for (auto& [label, area] : areas)
  {
    area /= total > 0.0 ? total : 1.0;
  }
  return areas;
}

/// Empty for what is no number.
std::string Number(double value)
{
  if (std::isnan(value))
  {
    return {};
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.4f", value);
  return text;
}

std::string CsvText(const std::string& text)
{
  if (text.find_first_of(",\"\n\r") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}
}

std::vector<CollectionRow> Summarize(const std::vector<CollectionEntry>& entries, vtkTable* table,
  const std::vector<vtkPolyData*>& meshes)
{
  std::vector<CollectionRow> rows;
  vtkIdType next = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    CollectionRow row;
    row.Name = entries[i].Name;
    row.File = entries[i].File;
    row.Role = "failed";
    row.Note = entries[i].Error;
    if (entries[i].Mesh)
    {
      const auto value = [&](const char* column) { return table->GetValueByName(next, column); };
      row.Source = value("Source").ToString();
      row.Confidence = value("Confidence").ToDouble();
      row.Against = value("Against").ToDouble();
      row.Learning = value("Learning").ToDouble();
      row.HeldOutAccuracy = value("HeldOutAccuracy").ToDouble();
      row.HeldOutAccuracyLearnt = value("HeldOutAccuracyLearnt").ToDouble();
      row.Note = value("Note").ToString();
      if (meshes[i])
      {
        row.Role = value("IsSource").ToInt() != 0 ? "source" : "target";
        row.AreaOfLabel = AreaOfLabels(meshes[i]);
      }
      ++next;
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<CollectionRow> LeastSureFirst(std::vector<CollectionRow> rows)
{
  const auto rank = [](const CollectionRow& row) {
    return row.Role == "target" ? 0 : row.Role == "failed" ? 1 : 2;
  };
  std::stable_sort(rows.begin(), rows.end(),
    [&](const CollectionRow& a, const CollectionRow& b)
    { return std::make_tuple(rank(a), a.Confidence) < std::make_tuple(rank(b), b.Confidence); });
  return rows;
}

std::string ToCsv(const std::vector<CollectionRow>& rows)
{
  std::set<int> labels;
  for (const CollectionRow& row : rows)
  {
    for (const auto& [label, area] : row.AreaOfLabel)
    {
      labels.insert(label);
    }
  }
  std::string csv = "mesh,file,role,source,confidence,against";
  for (const int label : labels)
  {
    csv += ",area_" + std::to_string(label);
  }
  csv += ",learning,held_out_accuracy,held_out_accuracy_learnt,note\n";
  for (const CollectionRow& row : rows)
  {
    csv += CsvText(row.Name) + "," + CsvText(row.File) + "," + row.Role + "," +
      CsvText(row.Source) + "," + Number(row.Confidence) + "," + Number(row.Against);
    for (const int label : labels)
    {
      const auto found = row.AreaOfLabel.find(label);
      csv += "," + Number(found == row.AreaOfLabel.end() ? 0.0 : found->second);
    }
    csv += "," + Number(row.Learning) + "," + Number(row.HeldOutAccuracy) + "," +
      Number(row.HeldOutAccuracyLearnt) + "," + CsvText(row.Note) + "\n";
  }
  return csv;
}

std::string ToJson(const std::vector<CollectionRow>& rows)
{
  using Value = nlohmann::ordered_json;
  Value table = Value::array();
  for (const CollectionRow& row : rows)
  {
    Value areas = Value::object();
    for (const auto& [label, area] : row.AreaOfLabel)
    {
      areas[std::to_string(label)] = area;
    }
    table.push_back(
      { { "mesh", row.Name }, { "file", row.File }, { "role", row.Role }, { "source", row.Source },
        { "confidence", row.Confidence }, { "against", row.Against }, { "areas", areas },
        { "learning", row.Learning }, { "held_out_accuracy", row.HeldOutAccuracy },
        { "held_out_accuracy_learnt", row.HeldOutAccuracyLearnt }, { "note", row.Note } });
  }
  // A name that is no UTF-8 must not end the program.
  return table.dump(1, ' ', false, Value::error_handler_t::replace) + "\n";
}
