// SPDX-License-Identifier: BSD-3-Clause
#include "LabelColorMaps.h"

#include <vtkIdTypeArray.h>
#include <vtkMarrowLabelColors.h>
#include <vtkSMSettings.h>

#include <sstream>
#include <string>

namespace
{
/// Beyond it labels are grey. As many as the arrays of Marrow's filters let viewers look for.
constexpr int LastLabel = 255;
/// Below ParaView's site and user settings, above its built-in ones.
constexpr double Priority = 0.5;

/// A colour map in the form of ParaView's settings. Only the labels that are there appear in the
/// legend, but each keeps its colour whatever else is there. ParaView looks for as many different
/// values as the array says (vtkAbstractArray::MaxDiscreteValues, 32 in arrays of others); where there
/// are more, all have the NaN colour, here the grey of what has no label.
std::string LabelColorMap()
{
  std::ostringstream annotations;
  std::ostringstream colors;
  for (int label = -1; label <= LastLabel; ++label)
  {
    double rgb[3];
    vtkMarrowLabelColors::GetColor(label, rgb);
    const char* separator = label < 0 ? "" : ", ";
    annotations << separator << '"' << label << "\", \"" << (label < 0 ? "none" : "")
                << (label < 0 ? "" : std::to_string(label)) << '"';
    colors << separator << rgb[0] << ", " << rgb[1] << ", " << rgb[2];
  }
  return "{ \"PVLookupTable\": { \"IndexedLookup\": 1,"
         " \"ShowIndexedColorActiveValues\": 1, \"NanColor\": [0.8, 0.8, 0.8], \"Annotations\": [" +
    annotations.str() + "], \"IndexedColors\": [" + colors.str() + "] } }";
}
}

void RegisterLabelColorMaps()
{
  std::string settings = "{ \"array_lookup_tables\": {";
  const char* separator = " ";
  for (const char* array : { "SegmentId", "FirstSegmentId", "SecondSegmentId", "CorrespondenceId",
         "BranchCorrespondenceId" })
  {
    settings += separator + ("\"" + std::string(array) + "\": ") + LabelColorMap();
    separator = ", ";
  }
  settings += " } }";
  vtkSMSettings::GetInstance()->AddCollectionFromString(settings, Priority);
}
