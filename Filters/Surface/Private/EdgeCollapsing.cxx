// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeCollapsing.h"

#include <numeric>
#include <utility>

namespace marrow
{
EdgeCollapsing::EdgeCollapsing(TriangleMesh mesh)
  : Triangles(std::move(mesh))
  , Removed(this->Triangles.Triangles.size(), 0)
  , Target(this->Triangles.Points.size())
  , Mark(this->Triangles.Points.size(), 0)
  , Left(this->Triangles.NumberOfTriangles())
{
  std::iota(this->Target.begin(), this->Target.end(), 0);
}

int EdgeCollapsing::Survivor(int vertex)
{
  while (this->Target[vertex] != vertex)
  {
    vertex = this->Target[vertex] = this->Target[this->Target[vertex]];
  }
  return vertex;
}

bool EdgeCollapsing::CanCollapse(int halfEdge, bool backward)
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

void EdgeCollapsing::SetOutgoing(int vertex, int halfEdge)
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

void EdgeCollapsing::CloseUp(int halfEdge, int stays)
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

void EdgeCollapsing::Collapse(int halfEdge, bool backward)
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
}
