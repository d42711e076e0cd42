// SPDX-License-Identifier: BSD-3-Clause
#include "MeasureShapes.h"
#include "MeshBridge.h"
#include "SliceLanes.h"
#include "SliceWalker.h"

#include <vtkCreatureSource.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace marrow;
using namespace marrow::test;

namespace
{
struct PlaneThrough
{
  int Vertex;
  Eigen::Vector3d Normal;
  SliceBounds Bounds;
};

/// Planes along the normals of vertices and, where they hit edges and vertices along the way, along the
/// axes; each without a bound and with bounds that many slices exceed.
std::vector<PlaneThrough> ManyPlanes(const TriangleMesh& mesh, int stride)
{
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  std::vector<PlaneThrough> planes;
  SliceBounds tight;
  tight.Closed = tight.Open = 0.5 * mesh.BoundingBoxDiagonal();
  SliceBounds closedOnly = tight;
  closedOnly.Open = -1.0;
  for (int v = 0; v < mesh.NumberOfVertices(); v += stride)
  {
    if (mesh.Outgoing[v] < 0)
    {
      continue;
    }
    const Eigen::Vector3d across = normals[v].unitOrthogonal();
    for (const SliceBounds& bounds : { SliceBounds(), tight, closedOnly })
    {
      planes.push_back({ v, across, bounds });
      planes.push_back({ v, normals[v].cross(across), bounds });
      planes.push_back({ v, Eigen::Vector3d::UnitX(), bounds });
      planes.push_back({ v, Eigen::Vector3d::UnitZ(), bounds });
    }
  }
  return planes;
}

std::vector<Slice> SlicesInLanes(
  const SliceMesh& mesh, const std::vector<PlaneThrough>& planes, VectorUnits units)
{
  std::vector<Slice> slices(planes.size());
  std::vector<std::unique_ptr<SliceTracer>> tracers(SliceLaneCount);
  std::vector<std::size_t> planeOfLane(SliceLaneCount);
  std::size_t next = 0;
  FollowInLanes(
    mesh,
    [&](int lane) -> SliceCurve*
    {
      for (;;)
      {
        if (tracers[lane])
        {
          if (tracers[lane]->NextCurve())
          {
            return &tracers[lane]->Curve;
          }
          slices[planeOfLane[lane]] = tracers[lane]->Result();
        }
        if (next == planes.size())
        {
          return nullptr;
        }
        planeOfLane[lane] = next;
        const PlaneThrough& plane = planes[next++];
        tracers[lane] = std::make_unique<SliceTracer>(mesh);
        tracers[lane]->Begin(mesh.RankOfVertex[plane.Vertex], plane.Normal, plane.Bounds);
      }
    },
    units);
  return slices;
}

/// Every width of vectors that this processor has gives the bits of the walk of one slice; returns how
/// many slices came out in each state.
std::vector<int> ExpectTheWalkersBits(const TriangleMesh& mesh, int stride)
{
  const SliceMesh layout(mesh);
  const SliceWalker walker(mesh);
  const std::vector<PlaneThrough> planes = ManyPlanes(mesh, stride);
  std::vector<int> count(4, 0);
  for (const VectorUnits units : { VectorUnits::Baseline, VectorUnits::AVX2, VectorUnits::AVX512 })
  {
    if (!HasVectorUnits(units))
    {
      continue;
    }
    const std::vector<Slice> slices = SlicesInLanes(layout, planes, units);
    std::fill(count.begin(), count.end(), 0);
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      const Slice slice = walker.Walk(planes[i].Vertex, planes[i].Normal, planes[i].Bounds);
      EXPECT_EQ(slices[i].Type, slice.Type) << i;
      EXPECT_EQ(slices[i].Perimeter, slice.Perimeter) << i;
      EXPECT_EQ(slices[i].Center, slice.Center) << i;
      ++count[static_cast<int>(slice.Type)];
    }
  }
  return count;
}

int CountOf(const std::vector<int>& count, Slice::State state)
{
  return count[static_cast<int>(state)];
}
}

TEST(SliceLanes, HaveTheBitsOfOneWalkOnClosedMeshes)
{
  for (const TriangleMesh& mesh : { MakeEgg(4), MakeTorus(2.0, 0.5, 60, 20) })
  {
    const std::vector<int> count = ExpectTheWalkersBits(mesh, 3);
    EXPECT_GT(CountOf(count, Slice::State::Closed), 100);
    EXPECT_GT(CountOf(count, Slice::State::Abandoned), 100);
    EXPECT_EQ(CountOf(count, Slice::State::Open), 0);
  }
}

TEST(SliceLanes, HaveTheBitsOfOneWalkOnCreatures)
{
  for (const int shape : { vtkCreatureSource::BIPED, vtkCreatureSource::QUADRUPED })
  {
    vtkNew<vtkCreatureSource> creature;
    creature->SetShape(shape);
    creature->SetResolution(8000);
    creature->Update();
    TriangleMesh mesh;
    ASSERT_EQ(ToTriangleMesh(creature->GetOutput(), mesh), "");
    const std::vector<int> count = ExpectTheWalkersBits(mesh, 7);
    EXPECT_GT(CountOf(count, Slice::State::Closed), 1000);
  }
}

TEST(SliceLanes, HaveTheBitsOfOneWalkWhereCurvesMeetBorders)
{
  // A tube that is slit along its length, and has lost triangles here and there.
  const TriangleMesh mesh = Without(MakeCylinder(1.0, 10.0, 36, 60),
    [](const TriangleMesh& m, int t)
    {
      const Eigen::Vector3d c = m.Centroid(t);
      return t % 97 == 0 || std::abs(std::atan2(c.y(), c.x())) < 2.0 * Pi / 36;
    });
  const std::vector<int> count = ExpectTheWalkersBits(mesh, 2);
  EXPECT_GT(CountOf(count, Slice::State::Open), 100);
  EXPECT_GT(CountOf(count, Slice::State::Abandoned), 100);
}

TEST(SliceLanes, HaveTheBitsOfOneWalkOverTrianglesWithoutArea)
{
  TriangleMesh mesh = MakeSphere(1.0, 3);
  std::vector<int> ring;
  mesh.ForEachNeighbor(5, [&](int n) { ring.push_back(n); });
  for (const int n : ring)
  {
    mesh.Points[n] = mesh.Points[5];
  }
  const std::vector<int> count = ExpectTheWalkersBits(mesh, 1);
  EXPECT_GT(CountOf(count, Slice::State::Closed), 100);
}
