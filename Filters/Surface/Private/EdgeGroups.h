// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_EdgeGroups_h
#define marrow_EdgeGroups_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The half-edges of a mesh grouped by the two vertices they join, whatever their direction. Edges
/// come in the order of their lower and then their higher vertex, half-edges in their own. O(n) but
/// for vertices of many edges.
class EdgeGroups
{
public:
  explicit EdgeGroups(const TriangleMesh& mesh);

  int NumberOfEdges() const { return static_cast<int>(this->First.size()) - 1; }
  int SizeOf(int edge) const { return this->First[edge + 1] - this->First[edge]; }
  const int* begin(int edge) const { return this->HalfEdges.data() + this->First[edge]; }
  const int* end(int edge) const { return this->HalfEdges.data() + this->First[edge + 1]; }

private:
  std::vector<int> HalfEdges;
  std::vector<int> First;
};
}

#endif
