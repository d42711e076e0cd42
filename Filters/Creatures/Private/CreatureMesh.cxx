// SPDX-License-Identifier: BSD-3-Clause
#include "CreatureMesh.h"

#include "CreatureSegments.h"
#include "CreatureSkeleton.h"
#include "ImplicitCreature.h"
#include "MeshCheck.h"
#include "MeshRelaxation.h"
#include "SurfaceNets.h"

#include <cmath>

namespace marrow
{
namespace
{
enum RandomStream : unsigned int
{
  ProportionStream = 1,
  NoiseStream = 2,
  FirstPoseStream = 16
};

CreatureSkeleton SkeletonOf(const Creature& creature)
{
  return MakeCreatureSkeleton(creature, ImplicitCreature(creature));
}

/// The first of a series of random poses in which no limb touches another. After a dozen at full
/// amplitude the amplitude shrinks, so that the search ends at the rest pose.
Creature MakeClearCreature(const CreatureParameters& parameters)
{
  constexpr int FullAttempts = 12;
  constexpr int Attempts = 40;
  auto make = [&](int attempt, double pose)
  {
    Variation proportions(parameters.Seed, ProportionStream, parameters.Proportion);
    Variation bends(parameters.Seed, FirstPoseStream + attempt, pose);
    return MakeCreature(parameters.Kind, proportions, bends);
  };
  const Creature resting = make(0, 0.0);
  if (parameters.Pose <= 0.0)
  {
    return resting;
  }
  const CreatureSkeleton restingSkeleton = SkeletonOf(resting);
  for (int attempt = 0; attempt < Attempts; ++attempt)
  {
    const double amplitude = std::pow(0.9, std::max(0, attempt - FullAttempts));
    const Creature creature = make(attempt, amplitude * parameters.Pose);
    if (HasClearance(SkeletonOf(creature), restingSkeleton, creature))
    {
      return creature;
    }
  }
  return resting;
}

/// A manifold contour of about the number of triangles asked for.
bool Contour(const ImplicitCreature& implicit, int resolution, int expectedGenus,
  TriangleMesh& mesh, const Progress& progress)
{
  constexpr double Tolerance = 0.03;
  constexpr int Attempts = 24;
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  implicit.Bounds(low, high);
  auto function = [&implicit](const Eigen::Vector3d& point) { return implicit.Value(point); };
  // The number of triangles goes with 1 / spacing²; a coarse contour tells the factor.
  double spacing = (high - low).norm() / 60.0;
  for (int attempt = 0; attempt < Attempts; ++attempt)
  {
    if (!Report(progress, 0.6 * attempt / Attempts))
    {
      return false;
    }
    // Another offset each time: where sheets meet in an awkward cell, the next grid parts them.
    const Eigen::Vector3d shift =
      spacing * (Eigen::Vector3d(1.13, 1.29, 1.41) + attempt * Eigen::Vector3d(0.07, 0.05, 0.03));
    mesh =
      SurfaceNets(function, low - shift, high + Eigen::Vector3d::Constant(2.0 * spacing), spacing);
    const double ratio = static_cast<double>(mesh.NumberOfTriangles()) / resolution;
    const MeshReport report = CheckMesh(mesh);
    if (std::abs(ratio - 1.0) < (attempt < 4 ? Tolerance : 0.1) && report.ManifoldError().empty() &&
      report.IsClosed() && report.NumberOfComponents == 1 && report.Genus() == expectedGenus)
    {
      return true;
    }
    if (std::abs(ratio - 1.0) > Tolerance)
    {
      spacing *= std::sqrt(ratio);
    }
  }
  return false;
}
}

std::string MakeCreatureMesh(
  const CreatureParameters& parameters, CreatureMesh& result, const Progress& progress)
{
  const Creature creature = MakeClearCreature(parameters);
  const ImplicitCreature implicit(creature);
  const CreatureSkeleton skeleton = MakeCreatureSkeleton(creature, implicit);
  if (!Contour(implicit, parameters.Resolution, skeleton.Graph.NumberOfLoops(), result.Mesh,
        SubProgress(progress, 0.0, 0.5)))
  {
    return "The creature's thinnest limbs are lost at a resolution of " +
      std::to_string(parameters.Resolution) + " triangles: ask for more of them.";
  }
  constexpr int RelaxationRounds = 6;
  RelaxMesh(
    result.Mesh, [&implicit](const Eigen::Vector3d& point) { return implicit.Project(point); },
    RelaxationRounds);
  if (!Report(progress, 0.8))
  {
    return {};
  }
  // Before the noise: neither labels nor φ should suffer from it.
  result.SegmentIds = SegmentCreature(creature, implicit, result.Mesh);
  result.KnownSkeleton = AssociateVertices(skeleton, implicit, result.Mesh);

  if (parameters.Noise > 0.0)
  {
    Variation noise(parameters.Seed, NoiseStream, 1.0);
    const double amplitude = parameters.Noise * result.Mesh.BoundingBoxDiagonal();
    const std::vector<Eigen::Vector3d> normals = result.Mesh.VertexNormals();
    for (int v = 0; v < result.Mesh.NumberOfVertices(); ++v)
    {
      result.Mesh.Points[v] += noise.Symmetric(amplitude) * normals[v];
    }
  }
  return {};
}
}
