// SPDX-License-Identifier: BSD-3-Clause
#include "MendedMesh.h"

namespace marrow
{
void MendedMesh::KeepTriangles(const std::vector<char>& keep)
{
  int kept = 0;
  for (int t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
  {
    if (keep[t])
    {
      this->Mesh.Triangles[kept] = this->Mesh.Triangles[t];
      this->CellOfTriangle[kept] = this->CellOfTriangle[t];
      ++kept;
    }
  }
  this->Mesh.Triangles.resize(kept);
  this->CellOfTriangle.resize(kept);
}
}
