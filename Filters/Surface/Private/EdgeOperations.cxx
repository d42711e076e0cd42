// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeOperations.h"

#include <numeric>
#include <utility>

namespace marrow
{
EdgeOperations::EdgeOperations(TriangleMesh mesh)
  : Triangles(std::move(mesh))
  , Removed(this->Triangles.Triangles.size(), 0)
  , Target(this->Triangles.Points.size())
  , Mark(this->Triangles.Points.size(), 0)
  , Left(this->Triangles.NumberOfTriangles())
{
  std::iota(this->Target.begin(), this->Target.end(), 0);
}

int EdgeOperations::Survivor(int vertex)
{
  while (this->Target[vertex] != vertex)
  {
    vertex = this->Target[vertex] = this->Target[this->Target[vertex]];
  }
  return vertex;
}

bool EdgeOperations::CanCollapse(int halfEdge, bool backward)
{
  const TriangleMesh& mesh = this->Triangles;
  const int opposite = mesh.Opposite[halfEdge];
  const int goes = backward ? mesh.To(halfEdge) : mesh.From(halfEdge);
  const int stays = backward ? mesh.From(halfEdge) : mesh.To(halfEdge);
  // A border vertex stays on its border.
  if (opposite >= 0 && this->IsBorder(goes))
  {
    return false;
  }
  // A triangle whose two other edges are both borders would vanish with its apex.
  for (int h : { halfEdge, opposite })
  {
    if (h >= 0 && mesh.Opposite[TriangleMesh::Next(h)] < 0 &&
      mesh.Opposite[TriangleMesh::Previous(h)] < 0)
    {
      return false;
    }
  }
  // The link condition: the ends have no common neighbours but the apexes.
  ++this->Query;
  mesh.ForEachNeighbor(goes, [&](int v) { this->Mark[v] = this->Query; });
  int common = 0;
  mesh.ForEachNeighbor(stays, [&](int v) { common += this->Mark[v] == this->Query ? 1 : 0; });
  if (common != (opposite >= 0 ? 2 : 1))
  {
    return false;
  }
  // An apex inside needs three other neighbours to stay one: else its triangles fold together.
  for (int h : { halfEdge, opposite })
  {
    if (h < 0)
    {
      continue;
    }
    const int apex = mesh.To(TriangleMesh::Next(h));
    int neighbors = 0;
    mesh.ForEachNeighbor(apex, [&](int) { ++neighbors; });
    if (neighbors <= (this->IsBorder(apex) ? 2 : 3))
    {
      return false;
    }
  }
  return true;
}

void EdgeOperations::SetOutgoing(int vertex, int halfEdge)
{
  // On a border the first of the fan.
  int walk = halfEdge;
  while (this->Triangles.Opposite[walk] >= 0)
  {
    walk = TriangleMesh::Next(this->Triangles.Opposite[walk]);
    if (walk == halfEdge)
    {
      break;
    }
  }
  this->Triangles.Outgoing[vertex] = walk;
}

void EdgeOperations::CloseUp(int halfEdge, int stays)
{
  TriangleMesh& mesh = this->Triangles;
  const int toApex = TriangleMesh::Next(halfEdge);
  const int fromApex = TriangleMesh::Previous(halfEdge);
  const int apex = mesh.To(toApex);
  const int outgoing = mesh.Opposite[toApex];   // leaves the apex
  const int incoming = mesh.Opposite[fromApex]; // leads to it
  if (outgoing >= 0)
  {
    mesh.Opposite[outgoing] = incoming;
  }
  if (incoming >= 0)
  {
    mesh.Opposite[incoming] = outgoing;
  }
  this->Removed[halfEdge / 3] = 1;
  --this->Left;
  mesh.Outgoing[apex] = outgoing >= 0 ? outgoing : TriangleMesh::Next(incoming);
  mesh.Outgoing[stays] = incoming >= 0 ? incoming : TriangleMesh::Next(outgoing);
}

void EdgeOperations::Collapse(int halfEdge, bool backward)
{
  TriangleMesh& mesh = this->Triangles;
  const int opposite = mesh.Opposite[halfEdge];
  const int goes = backward ? mesh.To(halfEdge) : mesh.From(halfEdge);
  const int stays = backward ? mesh.From(halfEdge) : mesh.To(halfEdge);
  this->Fan.clear();
  mesh.ForEachOutgoing(goes, [&](int h) { this->Fan.push_back(h); });
  for (int h : this->Fan)
  {
    mesh.Triangles[h / 3][h % 3] = stays;
  }
  const int apex = mesh.To(TriangleMesh::Next(halfEdge));
  const int otherApex = opposite >= 0 ? mesh.To(TriangleMesh::Next(opposite)) : -1;
  this->CloseUp(halfEdge, stays);
  if (opposite >= 0)
  {
    this->CloseUp(opposite, stays);
  }
  for (int vertex : { stays, apex, otherApex })
  {
    if (vertex >= 0)
    {
      this->SetOutgoing(vertex, mesh.Outgoing[vertex]);
    }
  }
  this->Target[goes] = stays;
  mesh.Outgoing[goes] = -1;
}

bool EdgeOperations::CanFlip(int halfEdge) const
{
  const TriangleMesh& mesh = this->Triangles;
  const int opposite = mesh.Opposite[halfEdge];
  if (opposite < 0)
  {
    return false;
  }
  const int apex = mesh.To(TriangleMesh::Next(halfEdge));
  const int otherApex = mesh.To(TriangleMesh::Next(opposite));
  bool joined = apex == otherApex;
  mesh.ForEachNeighbor(apex, [&](int v) { joined = joined || v == otherApex; });
  return !joined;
}

void EdgeOperations::Flip(int halfEdge)
{
  TriangleMesh& mesh = this->Triangles;
  const int opposite = mesh.Opposite[halfEdge];
  const int from = mesh.From(halfEdge);
  const int to = mesh.To(halfEdge);
  const int apex = mesh.To(TriangleMesh::Next(halfEdge));
  const int otherApex = mesh.To(TriangleMesh::Next(opposite));
  const int first = 3 * (halfEdge / 3);
  const int second = 3 * (opposite / 3);
  const int toApex = mesh.Opposite[TriangleMesh::Next(halfEdge)];
  const int fromApex = mesh.Opposite[TriangleMesh::Previous(halfEdge)];
  const int toOther = mesh.Opposite[TriangleMesh::Next(opposite)];
  const int fromOther = mesh.Opposite[TriangleMesh::Previous(opposite)];
  mesh.Triangles[first / 3] = { from, otherApex, apex };
  mesh.Triangles[second / 3] = { otherApex, to, apex };
  const std::pair<int, int> partners[] = { { first, toOther }, { first + 1, second + 2 },
    { first + 2, fromApex }, { second, fromOther }, { second + 1, toApex } };
  for (const auto& [h, g] : partners)
  {
    mesh.Opposite[h] = g;
    if (g >= 0)
    {
      mesh.Opposite[g] = h;
    }
  }
  this->SetOutgoing(from, first);
  this->SetOutgoing(otherApex, second);
  this->SetOutgoing(to, second + 1);
  this->SetOutgoing(apex, first + 2);
}
}
