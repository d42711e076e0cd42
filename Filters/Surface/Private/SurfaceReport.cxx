// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceReport.h"

namespace marrow
{
namespace
{
std::string WithSeparators(int count)
{
  std::string digits = std::to_string(count);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
  {
    digits.insert(i, ",");
  }
  return digits;
}
}

std::vector<SurfaceReport::Entry> SurfaceReport::Entries() const
{
  return {
    { "UnusedPoints", this->UnusedPoints },
    { "CutPolygons", this->CutPolygons },
    { "MergedPoints", this->MergedPoints },
    { "FacesWithoutArea", this->FacesWithoutArea },
    { "FacesTwice", this->FacesTwice },
    { "SplitEdges", this->SplitEdges },
    { "TurnedFaces", this->TurnedFaces },
    { "CutEdges", this->CutEdges },
    { "SplitPoints", this->SplitPoints },
    { "FilledHoles", this->FilledHoles },
    { "LeftOutParts", this->LeftOutParts },
    { "UnitedParts", this->UnitedParts },
    { "WrappedShreds", this->WrappedShreds },
    { "SimplifiedTriangles", this->SimplifiedTriangles },
    { "NumberOfOtherCells", this->OtherCells },
  };
}

bool SurfaceReport::IsEmpty() const
{
  for (const Entry& entry : this->Entries())
  {
    if (entry.Count > 0)
    {
      return false;
    }
  }
  return true;
}

std::string SurfaceReport::Sentence(int numberOfFaces) const
{
  std::string sentence;
  auto add = [&](const std::string& before, int count, const char* one, const char* many)
  {
    if (count > 0)
    {
      sentence += (sentence.empty() ? "" : ", ") + before + " " + WithSeparators(count) + " " +
        (count == 1 ? one : many);
    }
  };
  add("left out", this->UnusedPoints, "unused point", "unused points");
  add("cut", this->CutPolygons, "polygon into triangles", "polygons into triangles");
  add("merged", this->MergedPoints, "equal point", "equal points");
  add("left out", this->FacesWithoutArea, "face without area", "faces without area");
  add("left out", this->FacesTwice, "face that is there twice", "faces that are there twice");
  add("parted the sheets at", this->SplitEdges, "edge of more than two faces",
    "edges of more than two faces");
  add("turned", this->TurnedFaces, "face", "faces");
  add("cut", this->CutEdges, "edge of a part that cannot be oriented",
    "edges of a part that cannot be oriented");
  add("parted the faces at", this->SplitPoints, "pinched point", "pinched points");
  add("filled", this->FilledHoles, "small hole", "small holes");
  add("left out", this->LeftOutParts, "part inside or far smaller than the others",
    "parts inside or far smaller than the others");
  add("united", this->UnitedParts, "part that touches another", "parts that touch");
  add("wrapped", this->WrappedShreds, "part beyond mending", "parts beyond mending");
  add("simplified", this->SimplifiedTriangles, "triangle", "triangles");
  if (this->SimplifiedTriangles > 0)
  {
    sentence += " to " + WithSeparators(numberOfFaces);
  }
  add("passed over", this->OtherCells, "vertex or line cell", "vertex and line cells");
  return sentence;
}
}
