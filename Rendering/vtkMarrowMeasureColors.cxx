// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowMeasureColors.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkMarrowMeasureColors);

namespace
{
constexpr int TableSize = 256;
constexpr double UpperPercentile = 0.95;
constexpr double FarAbove = 3.0;

using Knots = std::vector<std::array<unsigned char, 3>>;

/// Every tenth colour of viridis.
const Knots Sequential = { { 68, 1, 84 }, { 72, 36, 117 }, { 65, 68, 135 }, { 53, 95, 141 },
  { 42, 120, 142 }, { 33, 145, 140 }, { 34, 168, 132 }, { 68, 191, 112 }, { 122, 209, 81 },
  { 189, 223, 38 }, { 253, 231, 37 } };
const Knots Diverging = { { 0, 60, 110 }, { 0, 114, 178 }, { 130, 180, 220 }, { 247, 247, 247 },
  { 240, 170, 120 }, { 213, 94, 0 }, { 120, 45, 0 } };

/// The value below which the colours end, of values that are not negative.
double UpperEnd(std::vector<double>& values)
{
  const double largest = *std::max_element(values.begin(), values.end());
  const auto place =
    values.begin() + static_cast<std::ptrdiff_t>(UpperPercentile * (values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return largest > FarAbove * *place && *place > 0.0 ? *place : largest;
}
}

void vtkMarrowMeasureColors::GetRange(vtkDataArray* measure, double range[2])
{
  std::vector<double> values;
  std::vector<double> magnitudes;
  const int components = measure ? measure->GetNumberOfComponents() : 0;
  for (vtkIdType i = 0; measure && i < measure->GetNumberOfTuples(); ++i)
  {
    double value = components == 1 ? measure->GetComponent(i, 0) : 0.0;
    for (int k = 0; components > 1 && k < components; ++k)
    {
      value = std::hypot(value, measure->GetComponent(i, k));
    }
    if (std::isfinite(value))
    {
      values.push_back(value);
      magnitudes.push_back(std::abs(value));
    }
  }
  range[0] = 0.0;
  range[1] = 1.0;
  if (values.empty())
  {
    return;
  }
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  range[0] = *least;
  range[1] = *largest;
  if (*least >= 0.0)
  {
    range[1] = UpperEnd(magnitudes);
  }
  else if (*largest > 0.0)
  {
    range[1] = UpperEnd(magnitudes);
    range[0] = -range[1];
  }
  if (!(range[0] < range[1]))
  {
    range[1] = range[0] + (range[0] == 0.0 ? 1.0 : std::abs(range[0]));
  }
}

void vtkMarrowMeasureColors::FillLookupTable(vtkLookupTable* table, const double range[2])
{
  const Knots& knots = range[0] < 0.0 && range[1] > 0.0 ? Diverging : Sequential;
  table->SetVectorModeToMagnitude();
  table->SetNumberOfTableValues(TableSize);
  table->SetTableRange(range[0], range[1]);
  for (int i = 0; i < TableSize; ++i)
  {
    const double place = static_cast<double>(i) / (TableSize - 1) * (knots.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(place), knots.size() - 2);
    double rgb[3];
    for (int c = 0; c < 3; ++c)
    {
      rgb[c] = (knots[k][c] + (place - k) * (knots[k + 1][c] - knots[k][c])) / 255.0;
    }
    table->SetTableValue(i, rgb[0], rgb[1], rgb[2], 1.0);
  }
  const double grey[4] = { 0.8, 0.8, 0.8, 1.0 };
  table->SetNanColor(grey);
}

void vtkMarrowMeasureColors::SetUpScalarBar(
  vtkScalarBarActor* bar, vtkLookupTable* table, const char* title, int fontSize)
{
  bar->SetLookupTable(table);
  bar->SetTitle(title);
  bar->SetOrientationToHorizontal();
  bar->SetNumberOfLabels(2);
  bar->SetLabelFormat("%.3g");
  bar->UnconstrainedFontSizeOn();
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetColor(0.1, 0.1, 0.1);
    text->SetFontSize(fontSize);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
}

void vtkMarrowMeasureColors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TableSize: " << TableSize << "\n";
}
