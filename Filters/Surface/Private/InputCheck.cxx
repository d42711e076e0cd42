// SPDX-License-Identifier: BSD-3-Clause
#include "InputCheck.h"

#include "MeshCheck.h"

namespace marrow
{
std::string CheckInput(const PolygonMesh& input)
{
  if (input.Corners.empty())
  {
    return "The mesh has no face: connect a surface.";
  }
  Defect missing;
  for (int c = 0; c < input.NumberOfPolygons(); ++c)
  {
    for (int k = 0; k < input.SizeOf(c); ++k)
    {
      const int point = input.CornersOf(c)[k];
      if (point < 0 || point >= input.NumberOfPoints())
      {
        missing.Add(c);
        break;
      }
    }
  }
  if (missing.Count > 0)
  {
    return "The mesh has " + std::to_string(missing.Count) +
      (missing.Count == 1 ? " face that names" : " faces that name") +
      " a point that does not exist (the first is cell " + std::to_string(missing.First) +
      "): repair the cells.";
  }
  const std::vector<char> used = UsedPoints(input);
  Defect invalid;
  for (int p = 0; p < input.NumberOfPoints(); ++p)
  {
    if (used[p] && !input.Points[p].allFinite())
    {
      invalid.Add(p);
    }
  }
  if (invalid.Count > 0)
  {
    return "The mesh has " + std::to_string(invalid.Count) +
      (invalid.Count == 1 ? " point in use whose coordinates are"
                          : " points in use whose coordinates are") +
      " not finite (the first is point " + std::to_string(invalid.First) + "): remove or repair " +
      (invalid.Count == 1 ? "it." : "them.");
  }
  return {};
}

std::vector<char> UsedPoints(const PolygonMesh& input)
{
  std::vector<char> used(input.Points.size(), 0);
  for (int corner : input.Corners)
  {
    used[corner] = 1;
  }
  return used;
}
}
