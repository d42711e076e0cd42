// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BoundaryTransfer_h
#define marrow_BoundaryTransfer_h

#include "AnalyzedMesh.h"
#include "BoundarySnake.h"
#include "MeshPaths.h"
#include "SegmentLoops.h"
#include "SkeletonMap.h"

#include <optional>
#include <utility>
#include <vector>

namespace marrow
{
/// Where a source loop sits: on a chain, at a ratio from its front.
struct Seat
{
  int Chain = -1;
  double Ratio = 0.0;
};
/// Nothing if the loop encloses no branch, several, or one without a partner.
std::optional<Seat> FindSeat(
  const AnalyzedMesh& source, const MatchedSkeletons& match, const SegmentLoop& loop);

/// Transfers boundaries that enclose exactly one matched branch (transfer paper, 4.1 to 4.4).
class BoundaryTransfer
{
public:
  struct Parameters
  {
    double DihedralTolerance = 0.1; ///< λ, radians
    double SearchRegion = 0.02;     ///< of the longest geodesic distance
  };

  BoundaryTransfer(const AnalyzedMesh& source, const AnalyzedMesh& target,
    const MatchedSkeletons& match, const SkeletonMap& map, const Parameters& parameters);

  /// A loop on the target.
  struct Cut
  {
    TransferredCurve Curve;
    /// The triangles of the covering region, each with its side: 0 before, 1 beyond the curve as seen
    /// from the chain's front.
    std::vector<std::pair<int, char>> Sides;
    bool LeftIsFront = false; ///< whether the source loop's left side is the one before it
  };

  /// The plane of the loop is carried by the frames of the matched branches to
  /// `targetRatio` of the target's chain, and rays find the surface there. Nothing if source or
  /// target have no annulus.
  std::optional<Cut> Transfer(const SegmentLoop& loop, const Seat& seat, double targetRatio);

private:
  struct SourceLoop
  {
    std::vector<int> Vertices;
    FittingPlane Plane;        ///< looks along the chain
    double WidestOffset = 0.0; ///< of the loop from its plane
    double EdgeLength = 0.0;
    bool LeftIsFront = false;
  };
  /// The same on the target, before there is a curve.
  struct TargetRing
  {
    FittingPlane Plane;
    Eigen::Matrix3d ToTarget; ///< turns source directions
    double Scale = 1.0;       ///< target lengths over source lengths
    std::vector<int> Seeds;
  };
  SourceLoop Describe(const SegmentLoop& loop, const Seat& seat) const;
  std::optional<Cut> TransferToRing(const SourceLoop& loop, const TargetRing& ring);

  const AnalyzedMesh& Source;
  const AnalyzedMesh& Target;
  const MatchedSkeletons& Match;
  const SkeletonMap& Map;
  Parameters Settings;
  PathFinder SourcePaths;
  PathFinder TargetPaths;
  double SearchRadius;
};

/// Per triangle of the map's region whether its centroid lies before (0) or beyond (1) the closed
/// curve, which runs once round the cylinder and need not be a graph over u.
std::vector<std::pair<int, char>> SidesOfCurve(
  const CylinderMap& map, const std::vector<Eigen::Vector2d>& curve);
}

#endif
