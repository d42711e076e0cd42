// SPDX-License-Identifier: BSD-3-Clause
#include "CollapseComplex.h"
#include "EdgeCollapse.h"
#include "HomologyAnnotation.h"
#include "MeshCheck.h"
#include "ShrunkMesh.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace marrow;

bool IsZero(const HomologyClass& value)
{
  return std::all_of(value.begin(), value.end(), [](auto word) { return word == 0; });
}

/// The class of a closed walk over vertices.
HomologyClass ClassOf(const TriangleMesh& mesh, const std::vector<HomologyClass>& annotation,
  const std::vector<int>& walk)
{
  HomologyClass sum(annotation.front().size(), 0);
  for (std::size_t i = 0; i < walk.size(); ++i)
  {
    const int to = walk[(i + 1) % walk.size()];
    int edge = -1;
    mesh.ForEachOutgoing(walk[i],
      [&](int h)
      {
        if (mesh.To(h) == to)
        {
          edge = h;
        }
      });
    EXPECT_GE(edge, 0) << "the walk leaves the edges";
    for (std::size_t word = 0; word < sum.size(); ++word)
    {
      sum[word] ^= annotation[edge][word];
    }
  }
  return sum;
}

/// The vertices nearest to a circle of centres, as a closed walk along shortest edge paths.
std::vector<int> WalkAlong(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& stations)
{
  std::vector<int> walk;
  const auto nearest = [&](const Eigen::Vector3d& place)
  {
    int best = 0;
    for (int v = 1; v < mesh.NumberOfVertices(); ++v)
    {
      if ((mesh.Points[v] - place).squaredNorm() < (mesh.Points[best] - place).squaredNorm())
      {
        best = v;
      }
    }
    return best;
  };
  int at = nearest(stations.front());
  const int start = at;
  for (std::size_t i = 1; i <= stations.size(); ++i)
  {
    const int target = i < stations.size() ? nearest(stations[i]) : start;
    while (at != target)
    {
      walk.push_back(at);
      int best = -1;
      mesh.ForEachNeighbor(at,
        [&](int neighbor)
        {
          if (best < 0 ||
            (mesh.Points[neighbor] - mesh.Points[target]).norm() <
              (mesh.Points[best] - mesh.Points[target]).norm())
          {
            best = neighbor;
          }
        });
      at = best;
    }
  }
  return walk;
}

std::vector<Eigen::Vector3d> Circle(
  const Eigen::Vector3d& center, const Eigen::Vector3d& u, const Eigen::Vector3d& v, int stations)
{
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < stations; ++i)
  {
    const double angle = 2.0 * Pi * i / stations;
    result.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
  }
  return result;
}

TEST(HomologyAnnotation, TellsTheLoopsOfATorusApart)
{
  const TriangleMesh mesh = test::MakeTorus(3.0, 1.0, 48, 24);
  const auto annotation = AnnotateHalfEdges(mesh);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();

  const auto throughHole = ClassOf(
    mesh, annotation, WalkAlong(mesh, Circle(Eigen::Vector3d::Zero(), 4.0 * x, 4.0 * y, 48)));
  const auto aroundTube = ClassOf(mesh, annotation, WalkAlong(mesh, Circle(3.0 * x, x, z, 24)));
  EXPECT_FALSE(IsZero(throughHole));
  EXPECT_FALSE(IsZero(aroundTube));
  EXPECT_NE(throughHole, aroundTube);

  // Two parallel loops are homologous, and a triangle bounds.
  EXPECT_EQ(aroundTube, ClassOf(mesh, annotation, WalkAlong(mesh, Circle(-3.0 * y, y, z, 24))));
  for (const auto& triangle : mesh.Triangles)
  {
    ASSERT_TRUE(IsZero(ClassOf(mesh, annotation, { triangle[0], triangle[1], triangle[2] })));
  }
}

TEST(HomologyAnnotation, IsEmptyOnASphere)
{
  for (const auto& bits : AnnotateHalfEdges(test::MakeSphere(1.0, 2)))
  {
    ASSERT_TRUE(bits.empty());
  }
}

/// A torus whose vertices all lie on the circle in the middle of its tube.
std::vector<Eigen::Vector3d> ShrinkTorus(const TriangleMesh& mesh, double radius)
{
  std::vector<Eigen::Vector3d> shrunk = mesh.Points;
  for (auto& point : shrunk)
  {
    point.z() = 0.0;
    point *= radius / point.norm();
  }
  return shrunk;
}

TEST(EdgeCollapse, ATorusKeepsItsHoleAndLosesItsTube)
{
  for (const double tube : { 0.1, 1.0, 2.5 })
  {
    const TriangleMesh mesh = test::MakeTorus(3.0, tube, 30, 12);
    Skeleton skeleton;
    skeleton.Graph = CollapseToGraph(
      mesh, ShrinkTorus(mesh, 3.0), std::vector<double>(mesh.Points.size(), 2.0 * Pi * tube), {});
    skeleton.ExtractBranches();
    EXPECT_EQ(skeleton.NumberOfLoops(), 1) << "tube radius " << tube;
    EXPECT_EQ(skeleton.NumberOfComponents(), 1);
    // The loop goes around the hole: its nodes stand in every direction from the axis.
    double length = 0.0;
    for (const Branch& branch : skeleton.Branches)
    {
      length += branch.Length();
    }
    EXPECT_GT(length, 0.8 * 2.0 * Pi * 3.0);
  }
}

TEST(EdgeCollapse, HomotopyHoldsWhateverThePositions)
{
  // Positions without sense: the topology must not depend on them.
  const TriangleMesh torus = test::MakeTorus(2.0, 0.5, 20, 8);
  const TriangleMesh sphere = test::MakeSphere(1.0, 2);
  for (unsigned int seed = 1; seed <= 5; ++seed)
  {
    for (const TriangleMesh* mesh : { &torus, &sphere })
    {
      const std::vector<int> order = test::RandomOrder(mesh->NumberOfVertices(), seed);
      std::vector<Eigen::Vector3d> position;
      for (const int v : order)
      {
        position.push_back(mesh->Points[v]);
      }
      Skeleton skeleton;
      skeleton.Graph = CollapseToGraph(*mesh, position, std::vector<double>(order.size(), 1.0), {});
      EXPECT_EQ(skeleton.NumberOfLoops(), CheckMesh(*mesh).Genus()) << "seed " << seed;
      EXPECT_EQ(skeleton.NumberOfComponents(), 1);
    }
  }
}

TEST(EdgeCollapse, EveryVertexIsInOneNode)
{
  const TriangleMesh mesh = test::MakeTorus(3.0, 1.0, 24, 12);
  const SkeletonGraph graph = CollapseToGraph(
    mesh, ShrinkTorus(mesh, 3.0), std::vector<double>(mesh.Points.size(), 2.0 * Pi), {});
  std::vector<int> count(mesh.Points.size(), 0);
  for (auto [n, end] = boost::vertices(graph); n != end; ++n)
  {
    EXPECT_FALSE(graph[*n].Vertices.empty());
    for (const int v : graph[*n].Vertices)
    {
      ++count[v];
    }
  }
  EXPECT_TRUE(std::all_of(count.begin(), count.end(), [](int c) { return c == 1; }));
}

TEST(EdgeCollapse, StopsWhenAsked)
{
  const TriangleMesh mesh = test::MakeSphere(1.0, 5);
  const SkeletonGraph graph = CollapseToGraph(
    mesh, mesh.Points, std::vector<double>(mesh.Points.size(), 1.0), [](double) { return false; });
  EXPECT_EQ(boost::num_vertices(graph), 0u);
}

TEST(ShrunkMesh, LengthwiseSlicesAreNotTrusted)
{
  // A cylinder whose caps report a slice lengthwise, as tips do.
  const double length = 10.0;
  const TriangleMesh mesh = test::MakeCylinder(1.0, length, 32, 80);
  std::vector<double> msp(mesh.Points.size(), 2.0 * Pi);
  std::vector<Eigen::Vector3d> center(mesh.Points.size());
  int inCap = -1;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const Eigen::Vector3d& p = mesh.Points[v];
    const bool cap = std::hypot(p.x(), p.y()) < 0.5;
    center[v] = cap ? Eigen::Vector3d::Zero() : Eigen::Vector3d(0.0, 0.0, p.z());
    if (cap)
    {
      msp[v] = 2.0 * length + 4.0;
      inCap = v;
    }
  }
  const std::vector<unsigned char> valid(mesh.Points.size(), 1);
  const auto reliability = SliceReliability(mesh, msp, valid);
  ASSERT_GE(inCap, 0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (msp[v] > 2.0 * length)
    {
      EXPECT_LT(reliability[v], 0.25);
    }
    else
    {
      EXPECT_DOUBLE_EQ(reliability[v], 1.0);
    }
  }
  // The middle of the cap stays at the end instead of jumping to the middle of the cylinder.
  const auto shrunk = ShrinkMesh(mesh, msp, center, reliability);
  EXPECT_GT(std::abs(shrunk[inCap].z()), 0.4 * length);
}
}
