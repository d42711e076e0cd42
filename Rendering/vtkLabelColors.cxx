// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLabelColors.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkVariant.h"

#include <set>
#include <string>

vtkStandardNewMacro(vtkLabelColors);

namespace
{
constexpr int NumberOfColors = 12;
constexpr unsigned char Colors[NumberOfColors][3] = {
  { 204, 121, 167 }, // reddish purple
  { 230, 159, 0 },   // orange
  { 86, 180, 233 },  // sky blue
  { 240, 228, 66 },  // yellow
  { 0, 158, 115 },   // bluish green
  { 213, 94, 0 },    // vermilion
  { 0, 114, 178 },   // blue
  { 136, 34, 85 },   // wine
  { 51, 34, 136 },   // indigo
  { 68, 170, 153 },  // teal
  { 153, 153, 51 },  // olive
  { 204, 102, 119 }  // rose
};
constexpr double NoLabel = 0.8;
constexpr double Darkened = 0.6;
}

void vtkLabelColors::GetColor(vtkIdType label, double rgb[3])
{
  for (int k = 0; k < 3; ++k)
  {
    rgb[k] = NoLabel;
    if (label >= 0)
    {
      const double shade = label / NumberOfColors % 2 == 0 ? 1.0 : Darkened;
      rgb[k] = shade * Colors[label % NumberOfColors][k] / 255.0;
    }
  }
}

void vtkLabelColors::FillLookupTable(vtkLookupTable* table, vtkDataArray* labels)
{
  std::set<vtkIdType> distinct;
  for (vtkIdType i = 0; labels && i < labels->GetNumberOfTuples(); ++i)
  {
    distinct.insert(static_cast<vtkIdType>(labels->GetTuple1(i)));
  }
  table->ResetAnnotations();
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(distinct.size()));
  vtkIdType index = 0;
  for (const vtkIdType label : distinct)
  {
    double rgb[3];
    vtkLabelColors::GetColor(label, rgb);
    // Annotations keep the order in which they are set, and the n-th has the n-th colour.
    table->SetAnnotation(vtkVariant(label), std::to_string(label));
    table->SetTableValue(index++, rgb[0], rgb[1], rgb[2], 1.0);
  }
}

void vtkLabelColors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfColors: " << NumberOfColors << "\n";
}
