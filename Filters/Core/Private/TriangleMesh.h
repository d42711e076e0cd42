// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TriangleMesh_h
#define marrow_TriangleMesh_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace marrow
{
/// A triangle mesh with its half-edges, in contiguous arrays.
///
/// Half-edge h = 3 t + k runs from corner k of triangle t to corner (k + 1) % 3, so a triangle's
/// three half-edges follow one another and nothing but the opposite one has to be stored.
/// Vertex i is point i and triangle t is cell t of the vtkPolyData it came from.
struct TriangleMesh
{
  std::vector<Eigen::Vector3d> Points;
  std::vector<std::array<int, 3>> Triangles;

  /// Per half-edge: the half-edge of the neighbouring triangle, or -1 on a border and where an edge
  /// has not exactly two consistently oriented triangles.
  std::vector<int> Opposite;
  /// Per vertex: a half-edge that leaves it, the first of its fan if the vertex is on a border;
  /// -1 for a point that no triangle uses.
  std::vector<int> Outgoing;

  int NumberOfVertices() const { return static_cast<int>(this->Points.size()); }
  int NumberOfTriangles() const { return static_cast<int>(this->Triangles.size()); }

  /// Fills Opposite and Outgoing from Triangles. O(n).
  void BuildConnectivity();

  static int Next(int halfEdge) { return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1; }
  static int Previous(int halfEdge) { return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1; }
  static int TriangleOf(int halfEdge) { return halfEdge / 3; }
  int From(int halfEdge) const { return this->Triangles[halfEdge / 3][halfEdge % 3]; }
  int To(int halfEdge) const { return this->From(Next(halfEdge)); }

  /// Calls visit(halfEdge) for every half-edge that leaves `vertex`, in order around the vertex.
  /// On a border the last neighbour has no leaving half-edge: it is From(Previous(last half-edge)).
  template <typename Visit>
  void ForEachOutgoing(int vertex, Visit&& visit) const
  {
    const int first = this->Outgoing[vertex];
    int h = first;
    while (h >= 0)
    {
      visit(h);
      h = this->Opposite[Previous(h)];
      if (h == first)
      {
        break;
      }
    }
  }

  /// Calls visit(neighbour) once for every vertex that shares an edge with `vertex`.
  template <typename Visit>
  void ForEachNeighbor(int vertex, Visit&& visit) const
  {
    int last = -1;
    this->ForEachOutgoing(vertex,
      [&](int h)
      {
        visit(this->To(h));
        last = h;
      });
    if (last >= 0 && this->Opposite[Previous(last)] < 0)
    {
      visit(this->From(Previous(last)));
    }
  }

  /// Twice the area times the unit normal.
  Eigen::Vector3d AreaVector(int triangle) const;
  double Area(int triangle) const { return 0.5 * this->AreaVector(triangle).norm(); }
  Eigen::Vector3d Centroid(int triangle) const;

  std::vector<double> TriangleAreas() const;
  /// A third of the area of the triangles around each vertex.
  std::vector<double> VertexAreas() const;
  /// Angle-weighted unit normals; zero where a vertex has no triangle of positive area.
  std::vector<Eigen::Vector3d> VertexNormals() const;
  double BoundingBoxDiagonal() const;
};
}

#endif
