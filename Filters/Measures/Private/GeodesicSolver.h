// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_GeodesicSolver_h
#define marrow_GeodesicSolver_h

#include "Progress.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// Geodesic distances from several vertices at once.
///
/// A vertex takes the least of what its triangles offer. A triangle with known distances at two
/// corners unfolds the source into its plane (Novotni and Klein 2002): two distances to the ends of
/// an edge fix a point on its far side, and the straight line from there to the third corner counts
/// if it passes through the edge; otherwise the way goes along an edge. On a developable surface
/// that is exact, elsewhere the error is some tenths of a percent. Offers are monotone in the
/// distances they start from, so sweeps to and fro over the vertices converge from above whatever the
/// order, and soonest if it is that of the distances along edges from some vertex; an offer is looked at
/// again only where one of the two distances that it starts from has changed.
///
/// All sources of a call are carried through the sweep together, one in each lane: the geometry is
/// read once for all of them, and the compiler turns the lanes into vector instructions.
class GeodesicSolver
{
public:
  static constexpr int Lanes = 16;

  explicit GeodesicSolver(const TriangleMesh& mesh);

  /// The vertices by their way along edges from the first one, component after component; points that no triangle uses
  /// are left out. Distances are given in this order.
  const std::vector<int>& Order() const { return this->VertexOfRank; }
  /// Component c is made of the ranks from ComponentBegin()[c] to ComponentBegin()[c + 1].
  const std::vector<int>& ComponentBegin() const { return this->BeginOfComponent; }

  /// Distances from up to `Lanes` sources, given as ranks, all in the component. On return
  /// distances[Lanes * (r - first rank of the component) + lane] is the distance of rank r from
  /// sources[lane]; lanes without a source are infinite. Returns false when stopped.
  bool Distances(int component, const std::vector<int>& sources, std::vector<float>& distances,
    const Progress& progress = Progress()) const;

private:
  /// A triangle seen from one corner: the other two, and the corner's place in a frame with the
  /// origin at the first and the x axis through the second.
  struct Corner
  {
    int First;
    int Second;
    int CornerAtFirst; ///< of the same triangle, as an index into Corners
    int CornerAtSecond;
    float X;
    float Y;
    float Base;        ///< distance of the other two
    float InverseBase; ///< 0 if they coincide
    float ToFirst;
    float ToSecond;
  };

  /// Takes what the pending ones of a vertex's corners offer; true if one of its distances fell.
  /// `distances` are those of `firstRank` and the following, `own` the vertex's among them.
  static bool Update(const Corner* corners, const char* pending, int numberOfCorners,
    const float* distances, int firstRank, float* own);

  std::vector<int> VertexOfRank;
  std::vector<int> BeginOfComponent;
  std::vector<int> CornerOffset; ///< by rank, into Corners
  std::vector<Corner> Corners;
};
}

#endif
