// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeGroups.h"

#include <algorithm>
#include <utility>

namespace marrow
{
EdgeGroups::EdgeGroups(const TriangleMesh& mesh)
{
  // Counted into one bucket per lower vertex; within a bucket sorted by the higher one.
  const int numberOfHalfEdges = 3 * mesh.NumberOfTriangles();
  auto low = [&](int h) { return std::min(mesh.From(h), mesh.To(h)); };
  auto high = [&](int h) { return std::max(mesh.From(h), mesh.To(h)); };
  std::vector<int> place(mesh.Points.size() + 1, 0);
  for (int h = 0; h < numberOfHalfEdges; ++h)
  {
    ++place[low(h) + 1];
  }
  for (std::size_t v = 1; v < place.size(); ++v)
  {
    place[v] += place[v - 1];
  }
  std::vector<std::pair<int, int>> keys(numberOfHalfEdges);
  std::vector<int> next(place.begin(), place.end() - 1);
  for (int h = 0; h < numberOfHalfEdges; ++h)
  {
    keys[next[low(h)]++] = { high(h), h };
  }

  this->HalfEdges.resize(numberOfHalfEdges);
  this->First.reserve(numberOfHalfEdges / 2 + 1);
  for (std::size_t v = 0; v + 1 < place.size(); ++v)
  {
    std::sort(keys.begin() + place[v], keys.begin() + place[v + 1]);
    for (int i = place[v]; i < place[v + 1]; ++i)
    {
      if (i == place[v] || keys[i].first != keys[i - 1].first)
      {
        this->First.push_back(i);
      }
      this->HalfEdges[i] = keys[i].second;
    }
  }
  this->First.push_back(numberOfHalfEdges);
}
}
