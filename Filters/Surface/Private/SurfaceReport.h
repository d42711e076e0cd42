// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceReport_h
#define marrow_SurfaceReport_h

#include <string>
#include <vector>

namespace marrow
{
/// What was done to make a working surface of a mesh: a count per step, 0 where nothing was to do.
struct SurfaceReport
{
  int UnusedPoints = 0;        ///< points that no face uses, left out
  int CutPolygons = 0;         ///< polygons cut into triangles
  int MergedPoints = 0;        ///< points merged into another at the same place
  int FacesWithoutArea = 0;    ///< faces that use a point twice, or whose corners lie on a line
  int FacesTwice = 0;          ///< faces with the same corners as another
  int SplitEdges = 0;          ///< edges of more than two faces, parted into sheets
  int TurnedFaces = 0;         ///< faces turned to agree with their part and to look outwards
  int CutEdges = 0;            ///< edges cut as their part cannot be oriented (a Möbius strip)
  int SplitPoints = 0;         ///< vertices added where fans of faces touched in one
  int FilledHoles = 0;         ///< holes closed
  int LeftOutParts = 0;        ///< connected parts that lie inside a body, or are crumbs
  int UnitedParts = 0;         ///< connected parts united by a wrap
  int WrappedShreds = 0;       ///< connected parts wrapped as they were beyond mending
  int SimplifiedTriangles = 0; ///< triangles there were before simplification
  int OtherCells = 0;          ///< vertex and line cells, which are no surface, passed over

  /// The name of each count, as the field array that holds it, and the count.
  struct Entry
  {
    const char* Name;
    int Count;
  };
  std::vector<Entry> Entries() const;

  bool IsEmpty() const;
  /// What was done, in words: "merged 14,220 equal points, turned 3 faces"; empty if nothing was.
  std::string Sentence(int numberOfFaces) const;
};
}

#endif
