// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_PreparedSurface_h
#define marrow_PreparedSurface_h

#include "CanonicalFrame.h"
#include "MeshMeasures.h"
#include "Progress.h"
#include "Skeleton.h"
#include "VertexMeasures.h"
#include "WorkingSurface.h"

#include <string>
#include <vector>

class vtkPolyData;

/// From any vtkPolyData to the meshes that the algorithms run on, and back: not installed, as it speaks
/// the private words of Core and Surface.
namespace marrow
{
/// One body of the working surface in its canonical frame. Its vertices and triangles know those of the
/// working surface (OriginalVertex, OriginalTriangle).
using Body = CanonicalMesh;

/// A mesh made ready for the method.
struct PreparedSurface
{
  WorkingSurface Working;
  std::vector<int> CellOfPolygon; ///< the input's cell that each polygon of Working is
  int NumberOfCells = 0;          ///< of the input, vertices and lines among them
  std::vector<Body> Bodies;       ///< each matched by itself; the largest first

  /// The input point at, or nearest to, a vertex of a body.
  int PointOf(const Body& body, int vertex) const
  {
    return this->Working.PointOfVertex[body.OriginalVertex[vertex]];
  }
};

/// Whether the bodies of a mesh are each for itself, or all parts of one.
enum class BodyMode
{
  Apart,
  Together
};

/// `maximumFaces` of the working surface; 0: as many as there are. One sentence on what is wrong, or an
/// empty one; what `progress` stops is left unfinished.
std::string PrepareSurface(vtkPolyData* input, int maximumFaces, BodyMode mode,
  PreparedSurface& surface, const Progress& progress = {});

/// The measures among the input's point arrays, seen from the frame of `body`; a vector stays empty where
/// there is no such array. One sentence on the first value that is not finite, or an empty one.
std::string ReadMeasures(
  vtkPolyData* input, const PreparedSurface& surface, const Body& body, VertexMeasures& measures);

/// All measures of a body. False if `progress` asked to stop.
bool MeasureBody(const Body& body, const MeasureParameters& parameters, VertexMeasures& measures,
  const Progress& progress = {});

/// The defaults of vtkMSPField, which stand in its header alone.
MeasureParameters DefaultMeasureParameters();

/// Says what was mended, in the output's field data, where anything was.
void WriteNote(const PreparedSurface& surface, vtkPolyData* output);

/// Writes the measures of all bodies to the points of `output`, whose points are those of the input.
void WriteMeasures(
  const PreparedSurface& surface, const std::vector<VertexMeasures>& ofBodies, vtkPolyData* output);

/// Writes the skeletons of all bodies, each in the frame of its body, as one, and SkeletonNodeId to the
/// points of `mesh`, which are those of the input.
void WriteSkeletons(const PreparedSurface& surface, const std::vector<Skeleton>& ofBodies,
  vtkPolyData* skeleton, vtkPolyData* mesh);
}

#endif
