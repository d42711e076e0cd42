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
constexpr int NumberOfColors = 24;
constexpr unsigned char Colors[NumberOfColors][3] = {
  { 204, 121, 167 }, // reddish purple
  { 230, 159, 0 },   // orange
  { 86, 180, 233 },  // sky blue
  { 240, 228, 66 },  // yellow
  { 0, 158, 115 },   // bluish green
  { 213, 94, 0 },    // vermilion
  { 0, 114, 178 },   // blue
  { 17, 68, 0 },     // dark green
  { 68, 17, 153 },   // indigo
  { 34, 255, 153 },  // mint
  { 85, 0, 85 },     // plum
  { 238, 0, 85 },    // crimson
  { 102, 85, 221 },  // violet
  { 136, 68, 119 },  // mauve
  { 187, 238, 102 }, // lime
  { 85, 0, 119 },    // dark purple
  { 170, 0, 34 },    // red
  { 119, 34, 68 },   // wine
  { 153, 255, 204 }, // pale mint
  { 68, 119, 68 },   // moss
  { 187, 238, 255 }, // pale blue
  { 187, 170, 85 },  // sand
  { 187, 34, 170 },  // magenta
  { 170, 136, 255 }  // lavender
};
constexpr double NoLabel = 0.8;
}

void vtkLabelColors::GetColor(vtkIdType label, double rgb[3])
{
  for (int k = 0; k < 3; ++k)
  {
    rgb[k] = label < 0 ? NoLabel : Colors[label % NumberOfColors][k] / 255.0;
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
