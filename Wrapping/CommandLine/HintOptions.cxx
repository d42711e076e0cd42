// SPDX-License-Identifier: BSD-3-Clause
#include "HintOptions.h"

#include "CommandError.h"

#include <vtkAlgorithm.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <regex>

namespace
{
const std::regex& PairForm()
{
  static const std::regex form("([0-9]{1,18}):([0-9]{1,18})");
  return form;
}

std::string CheckPair(const std::string& text)
{
  return std::regex_match(text, PairForm())
    ? std::string()
    : "\"" + text + "\" is not SOURCE:TARGET, two numbers of points, as 740:71";
}

vtkIdType PointOf(const std::string& pair, bool isTarget)
{
  std::smatch numbers;
  std::regex_match(pair, numbers, PairForm());
  return std::stoll(numbers[isTarget ? 2 : 1].str());
}
}

void HintOptions::Declare(CLI::App& app)
{
  app
    .add_option("--hint", this->Hints,
      "A point of the source and one of the target that are of the same part, by their numbers, "
      "from 0")
    ->check(CLI::Validator(CheckPair, "SOURCE:TARGET"))
    ->expected(1)
    ->take_all();
  app
    .add_option("--forbid", this->Forbidden,
      "A point of the source and one of the target whose parts must not be taken for each other")
    ->check(CLI::Validator(CheckPair, "SOURCE:TARGET"))
    ->expected(1)
    ->take_all();
}

void HintOptions::Connect(vtkAlgorithm* filter, const Side& source, const Side& target) const
{
  for (const Side* side : { &source, &target })
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkUnsignedCharArray> forbidden;
    forbidden->SetName("Forbidden");
    for (const auto* pairs : { &this->Hints, &this->Forbidden })
    {
      for (const std::string& pair : *pairs)
      {
        const vtkIdType point = PointOf(pair, side == &target);
        if (point >= side->Mesh->GetNumberOfPoints())
        {
          throw CommandError(side->Path + ": it has no point " + std::to_string(point) +
            ", only 0 to " + std::to_string(side->Mesh->GetNumberOfPoints() - 1) + " (hint " +
            pair + ").");
        }
        points->InsertNextPoint(side->Mesh->GetPoint(point));
        forbidden->InsertNextValue(pairs == &this->Forbidden ? 1 : 0);
      }
    }
    vtkNew<vtkPolyData> hints;
    hints->SetPoints(points);
    hints->GetPointData()->AddArray(forbidden);
    filter->SetInputDataObject(side->Port, hints);
  }
}
