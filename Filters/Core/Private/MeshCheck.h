// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshCheck_h
#define marrow_MeshCheck_h

#include "TriangleMesh.h"

#include <string>

namespace marrow
{
/// How many there are of one kind of defect, and the id of the first.
struct Defect
{
  int Count = 0;
  int First = -1;

  void Add(int id)
  {
    if (this->Count++ == 0)
    {
      this->First = id;
    }
  }
};

/// What a mesh is and what is wrong with it.
struct MeshReport
{
  Defect InvalidPoints;       ///< NaN or infinite coordinates; point ids
  Defect UnusedPoints;        ///< points that no triangle uses; point ids
  Defect DegenerateTriangles; ///< a vertex used twice; cell ids
  Defect NonManifoldEdges;    ///< more than two triangles; id of one end
  Defect InconsistentEdges;   ///< two triangles that run it the same way; id of one end
  Defect NonManifoldVertices; ///< more than one fan of triangles; point ids
  Defect BorderEdges;         ///< one triangle only; id of one end
  int NumberOfComponents = 0; ///< connected over shared edges
  int NumberOfBorders = 0;    ///< closed chains of border edges
  int EulerCharacteristic = 0;

  bool IsClosed() const { return this->BorderEdges.Count == 0; }
  /// Sum of the genera of the components; meaningful for an oriented manifold.
  int Genus() const;

  /// One sentence that says what keeps the mesh from being an oriented manifold, where, and the
  /// remedy; empty if it is one. Borders and several components are no error here.
  std::string ManifoldError() const;
  /// One sentence if the mesh is open; empty if it is closed.
  std::string ClosedError() const;
};

/// Examines a mesh whose connectivity has been built. O(n log n).
MeshReport CheckMesh(const TriangleMesh& mesh);

/// The component of every triangle, numbered from 0 in the order of their first triangle.
std::vector<int> TriangleComponents(const TriangleMesh& mesh, int& numberOfComponents);
}

#endif
