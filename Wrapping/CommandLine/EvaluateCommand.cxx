// SPDX-License-Identifier: BSD-3-Clause
#include "EvaluateCommand.h"

#include "Console.h"
#include "MeshFiles.h"

#include <vtkMarrowSegmentationMetrics.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{
/// A measure that is not defined, such as the distance to a boundary that is not there, is empty.
std::string Number(double value)
{
  std::ostringstream text;
  text << std::setprecision(6) << value;
  return std::isfinite(value) ? text.str() : "";
}
}

CLI::App* EvaluateCommand::Declare(CLI::App& marrow)
{
  CLI::App* app = marrow.add_subcommand(
    "evaluate", "Compare segments with one or several references, and average over them");
  app->add_option("mesh", this->Mesh, "The mesh (" + files::ReadableMeshes() + ")")->required();
  app->add_option("--segments", this->Segments.File,
    "Segments to judge: a .seg file or a mesh of the same faces; without it the mesh holds them");
  app->add_option("--labels", this->Segments.Labels, files::LabelsHelp)->capture_default_str();
  app->add_option("--reference", this->References, "What they are held against: the same formats")
    ->required();
  app->add_option("--reference-labels", this->ReferenceLabels, "As --labels, in the references")
    ->capture_default_str();
  CLI::Option* json = app->add_flag("--json", this->Json, "Print JSON");
  app->add_flag("--csv", this->Csv, "Print CSV")->excludes(json);
  app->footer(
    "CutDiscrepancy, HammingDistance (MissingRate, FalseAlarmRate), RandError and the consistency "
    "errors\nare those of the Princeton segmentation benchmark: 0 is best. LabelAccuracy is the "
    "share of the area with\nequal ids: 1 is best. See vtkMarrowSegmentationMetrics.h.\n\n"
    "Examples:\n"
    "  marrow evaluate cow.off --segments cow.seg --reference truth.seg\n"
    "  marrow evaluate cow.vtp --reference human_0.seg human_1.seg human_2.seg --json");
  return app;
}

void EvaluateCommand::Run(Console& console)
{
  const vtkSmartPointer<vtkPolyData> segmented =
    files::ReadSegmented(this->Mesh, this->Segments, console);
  std::vector<Row> rows;
  for (const std::string& path : this->References)
  {
    const vtkSmartPointer<vtkPolyData> reference =
      files::ReadSegmented(this->Mesh, { path, this->ReferenceLabels }, console);
    rows.push_back(this->Compare(segmented, reference, path, console));
  }
  rows.push_back(this->Mean(rows));
  if (this->Json)
  {
    this->PrintJson(rows);
  }
  else if (this->Csv)
  {
    this->PrintCsv(rows);
  }
  else
  {
    this->PrintTable(rows);
  }
}

EvaluateCommand::Row EvaluateCommand::Compare(
  vtkPolyData* segmented, vtkPolyData* reference, const std::string& path, Console& console)
{
  vtkNew<vtkMarrowSegmentationMetrics> metrics;
  metrics->SetInputData(0, segmented);
  metrics->SetInputData(1, reference);
  console.Update(metrics, path);
  vtkTable* table = metrics->GetOutput();
  Row row{ path, {} };
  this->Names.clear();
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    this->Names.emplace_back(table->GetColumnName(column));
    row.Values.push_back(table->GetValue(0, column).ToDouble());
  }
  return row;
}

EvaluateCommand::Row EvaluateCommand::Mean(const std::vector<Row>& rows) const
{
  Row mean{ "mean", std::vector<double>(this->Names.size(), 0.0) };
  for (const Row& row : rows)
  {
    for (std::size_t i = 0; i < row.Values.size(); ++i)
    {
      mean.Values[i] += row.Values[i] / rows.size();
    }
  }
  return mean;
}

void EvaluateCommand::PrintTable(const std::vector<Row>& rows) const
{
  // With one reference its mean would say the same again.
  const std::size_t shown = rows.size() == 2 ? 1 : rows.size();
  constexpr int widthOfName = 24;
  std::vector<int> widths;
  std::cout << std::left << std::setw(widthOfName) << "" << std::right;
  for (std::size_t i = 0; i < shown; ++i)
  {
    const std::string title = i + 1 == rows.size() ? "mean" : files::Stem(rows[i].Reference);
    widths.push_back(2 + std::max<int>(8, static_cast<int>(title.size())));
    std::cout << std::setw(widths[i]) << title;
  }
  std::cout << "\n" << std::fixed << std::setprecision(4);
  for (std::size_t name = 0; name < this->Names.size(); ++name)
  {
    std::cout << std::left << std::setw(widthOfName) << this->Names[name] << std::right;
    for (std::size_t i = 0; i < shown; ++i)
    {
      std::cout << std::setw(widths[i]) << rows[i].Values[name];
    }
    std::cout << "\n";
  }
}

void EvaluateCommand::PrintCsv(const std::vector<Row>& rows) const
{
  std::cout << "reference";
  for (const std::string& name : this->Names)
  {
    std::cout << "," << name;
  }
  std::cout << "\n";
  for (const Row& row : rows)
  {
    std::cout << row.Reference;
    for (const double value : row.Values)
    {
      std::cout << "," << Number(value);
    }
    std::cout << "\n";
  }
}

void EvaluateCommand::PrintJson(const std::vector<Row>& rows) const
{
  // Values that are not finite become null.
  using Value = nlohmann::ordered_json;
  const auto measures = [this](Value& to, const Row& row)
  {
    for (std::size_t i = 0; i < row.Values.size(); ++i)
    {
      to[this->Names[i]] = row.Values[i];
    }
  };
  Value json = { { "mesh", this->Mesh }, { "references", Value::array() } };
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
  {
    Value reference = { { "reference", rows[i].Reference } };
    measures(reference, rows[i]);
    json["references"].push_back(reference);
  }
  measures(json["mean"], rows.back());
  // Names of files need not be UTF-8, JSON must.
  std::cout << json.dump(2, ' ', false, Value::error_handler_t::replace) << "\n";
}
