// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_RevolutionShapes_h
#define marrow_RevolutionShapes_h

#include "Constants.h"
#include "TestShapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Surfaces of revolution with segments along the axis.
namespace marrow::test
{
/// A profile from the foot up, and which segment it is from there on.
struct Ring
{
  double Height;
  double Radius;
  int Segment;
};

struct Labelled
{
  TriangleMesh Mesh;
  std::vector<int> Labels;
};

enum Segment
{
  Base,
  Belly,
  Neck,
  Lip,
  Handle
};

/// Straight between the rings, closed by a point at either end. Triangles are no longer than they are
/// wide, so that each is of one segment.
inline Labelled Turn(const std::vector<Ring>& profile)
{
  constexpr int around = 48;
  constexpr double step = 0.05;
  Labelled result;
  std::vector<int> segmentOfRing; // what is above it
  const auto addRing = [&](double height, double radius, int segment)
  {
    for (int k = 0; k < around; ++k)
    {
      const double angle = 2.0 * Pi * k / around;
      result.Mesh.Points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
    segmentOfRing.push_back(segment);
  };
  const auto addTriangle = [&](int a, int b, int c, int segment)
  {
    result.Mesh.Triangles.push_back({ a, b, c });
    result.Labels.push_back(segment);
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
  {
    const Ring& a = profile[i];
    const Ring& b = profile[i + 1];
    const int steps =
      std::max(1, static_cast<int>(std::hypot(b.Height - a.Height, b.Radius - a.Radius) / step));
    for (int s = 0; s < steps; ++s)
    {
      const double t = static_cast<double>(s) / steps;
      addRing((1.0 - t) * a.Height + t * b.Height, (1.0 - t) * a.Radius + t * b.Radius, a.Segment);
    }
  }
  addRing(profile.back().Height, profile.back().Radius, profile.back().Segment);
  const int rings = static_cast<int>(segmentOfRing.size());
  for (int r = 0; r + 1 < rings; ++r)
  {
    for (int k = 0; k < around; ++k)
    {
      const int a = r * around + k;
      const int b = r * around + (k + 1) % around;
      addTriangle(a, b, b + around, segmentOfRing[r]);
      addTriangle(a, b + around, a + around, segmentOfRing[r]);
    }
  }
  const int bottom = result.Mesh.NumberOfVertices();
  result.Mesh.Points.emplace_back(0.0, 0.0, profile.front().Height);
  result.Mesh.Points.emplace_back(0.0, 0.0, profile.back().Height);
  for (int k = 0; k < around; ++k)
  {
    const int next = (k + 1) % around;
    const int top = (rings - 1) * around;
    addTriangle(bottom, next, k, profile.front().Segment);
    addTriangle(bottom + 1, top + k, top + next, profile[profile.size() - 2].Segment);
  }
  result.Mesh.BuildConnectivity();
  return result;
}

inline Labelled Jug()
{
  return Turn({ { 0.0, 0.5, Base }, { 0.2, 0.45, Base }, { 0.25, 0.4, Belly }, { 0.8, 0.9, Belly },
    { 1.3, 0.8, Belly }, { 1.7, 0.3, Neck }, { 2.4, 0.28, Lip }, { 2.6, 0.5, Lip } });
}

/// Low and wide, with a long foot and a thicker neck.
inline Labelled Bowl()
{
  return Turn({ { 0.0, 0.8, Base }, { 0.4, 0.7, Base }, { 0.45, 0.6, Belly }, { 0.8, 1.5, Belly },
    { 1.2, 1.3, Belly }, { 1.5, 0.6, Neck }, { 1.9, 0.55, Lip }, { 2.0, 0.8, Lip } });
}

/// Half a ring beside the axis that touches the wall, as a second part of the same mesh.
inline void AddHandle(Labelled& jug, double radius, double height, double size)
{
  TriangleMesh ring = MakeTorus(size, 0.15 * size, 40, 12);
  ring = Rotated(ring, Eigen::Vector3d::UnitX(), 0.5 * Pi);
  const int first = jug.Mesh.NumberOfVertices();
  for (const Eigen::Vector3d& point : ring.Points)
  {
    jug.Mesh.Points.push_back(point + Eigen::Vector3d(radius, 0.0, height));
  }
  for (const auto& [a, b, c] : ring.Triangles)
  {
    jug.Mesh.Triangles.push_back({ first + a, first + b, first + c });
    jug.Labels.push_back(Handle);
  }
  jug.Mesh.BuildConnectivity();
}

inline Labelled Moved(Labelled shape)
{
  shape.Mesh =
    Translated(Scaled(Rotated(shape.Mesh, Eigen::Vector3d(1.0, 2.0, 0.5).normalized(), 2.1), 3.7),
      { 5.0, -2.0, 11.0 });
  shape.Mesh.BuildConnectivity();
  return shape;
}
}

#endif
