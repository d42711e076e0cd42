// SPDX-License-Identifier: BSD-3-Clause
#include "SlicePlaces.h"

#include "Constants.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace marrow
{
namespace
{
using Mask = std::shared_ptr<const std::vector<bool>>;

/// The triangles of the wall and those off it; null where hardly any stand off.
struct Parts
{
  Parts(const TriangleMesh& mesh, const SliceChain& slices)
  {
    std::vector<bool> isAppended(mesh.NumberOfTriangles());
    double area = 0.0;
    double total = 0.0;
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      isAppended[t] = slices.IsAppended(mesh.Centroid(t));
      total += mesh.Area(t);
      area += isAppended[t] ? mesh.Area(t) : 0.0;
    }
    constexpr double least = 0.01; // less is a lip, or a dent beside a step
    if (area > least * total)
    {
      std::vector<bool> isWall = isAppended;
      isWall.flip();
      this->Wall = std::make_shared<const std::vector<bool>>(std::move(isWall));
      this->Appended = std::make_shared<const std::vector<bool>>(std::move(isAppended));
    }
  }

  Mask Wall;
  Mask Appended;
};

/// What the places of the target's vertices have in common at all angles.
class Placing
{
public:
  Placing(const AnalyzedMesh& source, const TriangleMesh& target, const SliceAlignment& alignment)
    : Points(target.Points)
    , Normals(target.VertexNormals())
    , Radius(WholeSearchRadius * source.Diagonal())
  {
    const Parts parts(source.Mesh, alignment.GetSource());
    for (const Eigen::Vector3d& point : target.Points)
    {
      this->Among.push_back(alignment.GetTarget().IsAppended(point) ? parts.Appended : parts.Wall);
    }
  }

  SourceSearch::Query PlaceOf(int vertex, const SliceAlignment& alignment) const
  {
    SourceSearch::Query place;
    place.Position = alignment.ToSource(this->Points[vertex]);
    place.Normal = alignment.GetRotation() * this->Normals[vertex];
    place.Radius = this->Radius;
    place.Among = this->Among[vertex];
    return place;
  }

private:
  const std::vector<Eigen::Vector3d>& Points;
  std::vector<Eigen::Vector3d> Normals;
  double Radius;
  std::vector<Mask> Among;
};

/// By a spread of vertices.
double BestAngle(const Placing& placing, const TriangleMesh& target, SliceAlignment alignment,
  const SourceSearch& search)
{
  constexpr int numberOfAngles = 24;    // 15 degrees apart, less than a handle is wide
  constexpr int numberOfVertices = 500; // enough that a handle has some
  const int step = std::max(1, target.NumberOfVertices() / numberOfVertices);
  const std::vector<double> areas = target.VertexAreas();
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < numberOfAngles; ++k)
  {
    const double angle = 2.0 * Pi * k / numberOfAngles;
    alignment.SetAngle(angle);
    double sum = 0.0;
    for (int v = 0; v < target.NumberOfVertices(); v += step)
    {
      const SourceSearch::Query place = placing.PlaceOf(v, alignment);
      SourceSearch::Candidates candidates;
      search.UpdateCandidates(place, candidates);
      sum += areas[v] * search.Misfit(place, search.Best(place, candidates), place.Radius);
    }
    if (sum < least)
    {
      least = sum;
      best = angle;
    }
  }
  return best;
}
}

std::vector<SourceSearch::Query> PlacesBySlices(const AnalyzedMesh& source,
  const TriangleMesh& target, SliceAlignment alignment, const SourceSearch& search)
{
  const Placing placing(source, target, alignment);
  alignment.SetAngle(BestAngle(placing, target, alignment, search));
  std::vector<SourceSearch::Query> places;
  for (int v = 0; v < target.NumberOfVertices(); ++v)
  {
    places.push_back(placing.PlaceOf(v, alignment));
  }
  return places;
}
}
