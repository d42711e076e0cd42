// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PolygonMesh_h
#define marrow_PolygonMesh_h

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// A surface as it came: polygons of any size, in the order of the file.
struct PolygonMesh
{
  std::vector<Eigen::Vector3d> Points;
  std::vector<int> Offsets = { 0 }; ///< polygon c has the corners Offsets[c] ... Offsets[c + 1] - 1
  std::vector<int> Corners;         ///< point ids

  int NumberOfPoints() const { return static_cast<int>(this->Points.size()); }
  int NumberOfPolygons() const { return static_cast<int>(this->Offsets.size()) - 1; }
  int SizeOf(int polygon) const { return this->Offsets[polygon + 1] - this->Offsets[polygon]; }
  const int* CornersOf(int polygon) const { return this->Corners.data() + this->Offsets[polygon]; }
};
}

#endif
