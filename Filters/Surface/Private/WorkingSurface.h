// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_WorkingSurface_h
#define marrow_WorkingSurface_h

#include "PolygonMesh.h"
#include "Progress.h"
#include "SurfaceReport.h"
#include "TriangleMesh.h"

#include <string>
#include <vector>

namespace marrow
{
struct WorkingSurfaceParameters
{
  int MaximumFaces = 30000; ///< default of vtkWorkingSurface
};

/// The oriented manifold on which the method runs, and what it has to do with the mesh it was made of.
struct WorkingSurface
{
  /// The mesh mended, at its full resolution: an oriented manifold with its connectivity. Parts that
  /// the working surface leaves out or wraps are still in it.
  TriangleMesh Full;
  std::vector<int> CellOfFullTriangle; ///< the polygon it came from; -1: it fills a hole
  /// Per polygon one of its triangles; of one that has none (no area, there twice) the nearest or its
  /// twin's. Never -1.
  std::vector<int> FullTriangleOfCell;
  /// The input point at a vertex's place, one of them where several were merged; for a vertex in the
  /// middle of an edge one of its ends.
  std::vector<int> PointOfFullVertex;

  /// The working surface. At most MaximumFaces triangles, but for what its topology needs.
  TriangleMesh Mesh;
  std::vector<int> TriangleOfFullTriangle; ///< the working triangle it became or lies nearest to
  /// Per input point the working vertex it became or lies nearest to; -1 for one that no face uses.
  std::vector<int> VertexOfPoint;
  std::vector<int>
    PointOfVertex; ///< per working vertex: the input point at its place, or nearest to it

  /// Per working triangle the body it belongs to: connected parts, the one of most area first.
  std::vector<int> BodyOfTriangle;
  int NumberOfBodies = 0;

  bool IsInput = false; ///< nothing was to do: Full and Mesh are the input, bit for bit
  SurfaceReport Report;

  /// The working triangle of a polygon. Never -1.
  int TriangleOfCell(int cell) const
  {
    return this->TriangleOfFullTriangle[this->FullTriangleOfCell[cell]];
  }
  /// What was done, in words; empty if nothing was.
  std::string Sentence() const { return this->Report.Sentence(this->Mesh.NumberOfTriangles()); }
};

/// Makes a working surface of any mesh. Returns one sentence about what no program can use (no face,
/// points in use that are not finite), or an empty one. On abort `output` is not to be used.
std::string ComputeWorkingSurface(const PolygonMesh& input,
  const WorkingSurfaceParameters& parameters, const Progress& progress, WorkingSurface& output);
}

#endif
