// SPDX-License-Identifier: BSD-3-Clause
#include "CreatureSegments.h"

#include <map>

namespace marrow
{
namespace
{
/// The label that most neighbours of a triangle have which is not its own; -1 if there is none.
int OtherLabel(const TriangleMesh& mesh, const std::vector<int>& labels, int triangle, int& count)
{
  int best = -1;
  count = 0;
  for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
  {
    const int label = labels[TriangleMesh::TriangleOf(mesh.Opposite[h])];
    int same = 0;
    for (int g = 3 * triangle; g < 3 * triangle + 3; ++g)
    {
      same += labels[TriangleMesh::TriangleOf(mesh.Opposite[g])] == label;
    }
    if (label != labels[triangle] && same > count)
    {
      best = label;
      count = same;
    }
  }
  return best;
}

void FileTeeth(const TriangleMesh& mesh, std::vector<int>& labels)
{
  // A triangle in a tooth has two neighbours beyond the cut. Each turn shortens the cut by an edge,
  // so this ends.
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      int count = 0;
      const int other = OtherLabel(mesh, labels, t, count);
      if (count >= 2)
      {
        labels[t] = other;
        changed = true;
      }
    }
  }
}

/// Gives every piece of a segment but the largest to the label next to it.
void ConnectSegments(const TriangleMesh& mesh, std::vector<int>& labels)
{
  std::vector<int> piece(labels.size(), -1);
  std::vector<std::vector<int>> pieces;
  std::map<int, int> largestOfLabel;
  for (int seed = 0; seed < mesh.NumberOfTriangles(); ++seed)
  {
    if (piece[seed] >= 0)
    {
      continue;
    }
    const int id = static_cast<int>(pieces.size());
    std::vector<int> members{ seed };
    piece[seed] = id;
    for (std::size_t next = 0; next < members.size(); ++next)
    {
      for (int h = 3 * members[next]; h < 3 * members[next] + 3; ++h)
      {
        const int neighbor = TriangleMesh::TriangleOf(mesh.Opposite[h]);
        if (piece[neighbor] < 0 && labels[neighbor] == labels[seed])
        {
          piece[neighbor] = id;
          members.push_back(neighbor);
        }
      }
    }
    pieces.push_back(std::move(members));
    const auto [found, isNew] = largestOfLabel.insert({ labels[seed], id });
    if (!isNew && pieces[id].size() > pieces[found->second].size())
    {
      found->second = id;
    }
  }
  for (std::size_t id = 0; id < pieces.size(); ++id)
  {
    if (largestOfLabel.at(labels[pieces[id].front()]) == static_cast<int>(id))
    {
      continue;
    }
    int other = -1;
    for (int t : pieces[id])
    {
      int count = 0;
      const int label = OtherLabel(mesh, labels, t, count);
      other = label >= 0 && count > 0 ? label : other;
    }
    for (int t : pieces[id])
    {
      labels[t] = other;
    }
  }
}
}

std::vector<int> SegmentCreature(
  const Creature& creature, const ImplicitCreature& implicit, const TriangleMesh& mesh)
{
  std::vector<int> labels(mesh.Triangles.size());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const ImplicitCreature::Place place = implicit.PlaceOf(mesh.Centroid(t));
    labels[t] = creature.Limbs[place.Limb].SegmentAt(place.Fraction);
  }
  FileTeeth(mesh, labels);
  ConnectSegments(mesh, labels);
  return labels;
}
}
