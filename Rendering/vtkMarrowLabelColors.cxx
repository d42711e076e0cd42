// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowLabelColors.h"

#include "LabelPalette.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkVariant.h"

#include <set>
#include <string>

vtkStandardNewMacro(vtkMarrowLabelColors);

void vtkMarrowLabelColors::GetColor(vtkIdType label, double rgb[3])
{
  const auto& color =
    label < 0 ? marrow::NoLabelColor : marrow::LabelPalette[label % marrow::LabelPalette.size()];
  for (int k = 0; k < 3; ++k)
  {
    rgb[k] = color[k] / 255.0;
  }
}

void vtkMarrowLabelColors::FillLookupTable(vtkLookupTable* table, vtkDataArray* labels)
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
    vtkMarrowLabelColors::GetColor(label, rgb);
    // Annotations keep the order in which they are set, and the n-th has the n-th colour.
    table->SetAnnotation(vtkVariant(label), std::to_string(label));
    table->SetTableValue(index++, rgb[0], rgb[1], rgb[2], 1.0);
  }
}

void vtkMarrowLabelColors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfColors: " << marrow::LabelPalette.size() << "\n";
}
