// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "MeshBridge.h"
#include "MeshCheck.h"
#include "TestMeshes.h"
#include "WindingNumber.h"
#include "vtkCreatureSource.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

using namespace marrow;
using namespace marrow::test;

namespace
{
struct Kind
{
  const char* Name;
  int Shape;
  int Genus;
  int Terminals;
  int Segments;
};

const Kind Kinds[] = {
  { "Biped", vtkCreatureSource::BIPED, 0, 5, 7 },
  { "Quadruped", vtkCreatureSource::QUADRUPED, 0, 6, 8 },
  { "Octopus", vtkCreatureSource::OCTOPUS, 0, 9, 9 },
  { "Chair", vtkCreatureSource::CHAIR, 3, 4, 8 },
  { "Snake", vtkCreatureSource::SNAKE, 0, 2, 3 },
  { "Torus", vtkCreatureSource::TORUS, 1, 0, 2 },
  { "Capsule", vtkCreatureSource::CAPSULE, 0, 2, 3 },
};

class CreatureSource : public ::testing::TestWithParam<Kind>
{
};

std::vector<int> SegmentsOf(const Creature& creature)
{
  std::vector<int> segments;
  GetArray(creature.Mesh->GetCellData(), names::SegmentId,
    static_cast<int>(creature.Mesh->GetNumberOfCells()), segments);
  return segments;
}

/// The number of connected pieces per segment.
std::map<int, int> PiecesOfSegments(const TriangleMesh& mesh, const std::vector<int>& segments)
{
  std::map<int, int> pieces;
  std::vector<bool> seen(segments.size(), false);
  for (std::size_t seed = 0; seed < segments.size(); ++seed)
  {
    if (seen[seed])
    {
      continue;
    }
    ++pieces[segments[seed]];
    std::vector<int> stack{ static_cast<int>(seed) };
    seen[seed] = true;
    while (!stack.empty())
    {
      const int t = stack.back();
      stack.pop_back();
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        const int neighbor = TriangleMesh::TriangleOf(mesh.Opposite[h]);
        if (!seen[neighbor] && segments[neighbor] == segments[t])
        {
          seen[neighbor] = true;
          stack.push_back(neighbor);
        }
      }
    }
  }
  return pieces;
}

double SmallestAngle(const TriangleMesh& mesh)
{
  double smallest = Pi;
  for (const auto& t : mesh.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d a = mesh.Points[t[(k + 1) % 3]] - mesh.Points[t[k]];
      const Eigen::Vector3d b = mesh.Points[t[(k + 2) % 3]] - mesh.Points[t[k]];
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return smallest * 180.0 / Pi;
}

/// Everything that holds for any creature; `genus` and so on by kind.
void ExpectSound(const Kind& kind, const CreatureOptions& options)
{
  SCOPED_TRACE(std::string(kind.Name) + " seed " + std::to_string(options.Seed) + " pose " +
    std::to_string(options.Pose) + " proportion " + std::to_string(options.Proportion) + " faces " +
    std::to_string(options.Faces));
  const Creature creature = MakeCreature(kind.Shape, options);
  TriangleMesh mesh;
  ASSERT_EQ(ToTriangleMesh(creature.Mesh, mesh), "");
  const MeshReport report = CheckMesh(mesh);
  EXPECT_EQ(report.ManifoldError(), "");
  EXPECT_EQ(report.ClosedError(), "");
  EXPECT_EQ(report.NumberOfComponents, 1);
  EXPECT_EQ(report.Genus(), kind.Genus);
  EXPECT_EQ(report.UnusedPoints.Count, 0);
  EXPECT_GT(SignedVolume(mesh), 0.0);
  EXPECT_NEAR(mesh.NumberOfTriangles(), options.Faces, 0.1 * options.Faces + 1);
  EXPECT_GT(SmallestAngle(mesh), 1.0);

  const std::map<int, int> pieces = PiecesOfSegments(mesh, SegmentsOf(creature));
  EXPECT_EQ(static_cast<int>(pieces.size()), kind.Segments);
  for (const auto& [segment, count] : pieces)
  {
    EXPECT_GE(segment, 0);
    EXPECT_LT(segment, kind.Segments);
    EXPECT_EQ(count, 1) << "segment " << segment << " is in pieces";
  }

  vtkDataArray* type = creature.Skeleton->GetPointData()->GetArray(names::NodeType);
  int terminals = 0;
  for (vtkIdType n = 0; n < type->GetNumberOfTuples(); ++n)
  {
    terminals += type->GetTuple1(n) == 1.0;
  }
  EXPECT_EQ(terminals, kind.Terminals);
  Skeleton skeleton;
  const vtkSmartPointer<vtkPolyData> withMeasures = [&]
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(creature.Skeleton);
    const std::vector<double> zeros(copy->GetNumberOfPoints(), 0.0);
    SetArray(copy->GetPointData(), names::AGD, zeros);
    SetArray(copy->GetPointData(), names::MSP, zeros);
    return copy;
  }();
  ASSERT_EQ(ToSkeleton(withMeasures, skeleton), "");
  EXPECT_EQ(skeleton.NumberOfLoops(), kind.Genus);
  EXPECT_EQ(skeleton.NumberOfComponents(), 1);
  EXPECT_NEAR(skeleton.MeshDiagonal, mesh.BoundingBoxDiagonal(), 1e-12);

  std::vector<int> nodeOfVertex;
  ASSERT_TRUE(GetArray(
    creature.Mesh->GetPointData(), names::SkeletonNodeId, mesh.NumberOfVertices(), nodeOfVertex));
  ASSERT_TRUE(SetNodeOfVertices(skeleton, nodeOfVertex));
  EXPECT_EQ(std::count(nodeOfVertex.begin(), nodeOfVertex.end(), -1), 0);
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    const SkeletonNode& node = skeleton.Graph[n];
    EXPECT_GT(node.Radius, 0.0);
    if (skeleton.TypeOf(n) == NodeType::Terminal)
    {
      EXPECT_FALSE(node.Vertices.empty()) << "terminal " << n << " has no surface";
    }
  }
}

/// Every node lies inside the surface.
void ExpectNodesInside(const Creature& creature)
{
  TriangleMesh mesh;
  ASSERT_EQ(ToTriangleMesh(creature.Mesh, mesh), "");
  for (vtkIdType n = 0; n < creature.Skeleton->GetNumberOfPoints(); ++n)
  {
    const Eigen::Vector3d node(creature.Skeleton->GetPoint(n));
    EXPECT_NEAR(WindingNumber(mesh, node), 1.0, 1e-6) << "node " << n << " is not inside";
  }
}

bool SameBits(const Creature& a, const Creature& b)
{
  if (a.Mesh->GetNumberOfPoints() != b.Mesh->GetNumberOfPoints() ||
    a.Mesh->GetNumberOfCells() != b.Mesh->GetNumberOfCells())
  {
    return false;
  }
  TriangleMesh meshA;
  TriangleMesh meshB;
  ToTriangleMesh(a.Mesh, meshA);
  ToTriangleMesh(b.Mesh, meshB);
  return meshA.Points == meshB.Points && meshA.Triangles == meshB.Triangles &&
    SegmentsOf(a) == SegmentsOf(b);
}
}

TEST_P(CreatureSource, RestPoseIsSoundAtEveryResolution)
{
  for (const int faces : { 5000, 12000 })
  {
    CreatureOptions options;
    options.Faces = faces;
    ExpectSound(GetParam(), options);
  }
}

TEST_P(CreatureSource, EveryIndividualIsSound)
{
  for (int seed = 1; seed <= 4; ++seed)
  {
    CreatureOptions options;
    options.Seed = seed;
    options.Pose = seed % 2 == 0 ? 1.0 : 0.6;
    options.Proportion = seed % 3 == 0 ? 0.0 : 1.0;
    ExpectSound(GetParam(), options);
  }
}

TEST_P(CreatureSource, SkeletonLiesInside)
{
  CreatureOptions options;
  options.Pose = 1.0;
  options.Proportion = 1.0;
  options.Seed = 2;
  ExpectNodesInside(MakeCreature(GetParam().Shape, options));
}

TEST_P(CreatureSource, SameParametersSameBits)
{
  CreatureOptions options;
  options.Seed = 7;
  options.Pose = 0.8;
  options.Proportion = 0.8;
  options.Noise = 0.001;
  const Creature first = MakeCreature(GetParam().Shape, options);
  vtkSMPTools::Initialize(1);
  const Creature second = MakeCreature(GetParam().Shape, options);
  vtkSMPTools::Initialize(0);
  EXPECT_TRUE(SameBits(first, second));
  options.Seed = 8;
  EXPECT_FALSE(SameBits(first, MakeCreature(GetParam().Shape, options)));
}

INSTANTIATE_TEST_SUITE_P(Kinds, CreatureSource, ::testing::ValuesIn(Kinds),
  [](const auto& kind) { return std::string(kind.param.Name); });

TEST(CreaturePose, MovesExtremitiesAndKeepsLengths)
{
  // The whole skeleton's length does not change with the pose, the place of its ends does.
  for (const int shape : { vtkCreatureSource::BIPED, vtkCreatureSource::QUADRUPED,
         vtkCreatureSource::OCTOPUS, vtkCreatureSource::SNAKE })
  {
    const Creature rest = MakeCreature(shape);
    auto length = [](const Creature& creature)
    {
      vtkDataArray* array = creature.Skeleton->GetCellData()->GetArray(names::BranchLength);
      double sum = 0.0;
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        sum += array->GetTuple1(i);
      }
      return sum;
    };
    for (int seed = 1; seed <= 2; ++seed)
    {
      CreatureOptions options;
      options.Seed = seed;
      options.Pose = 1.0;
      const Creature posed = MakeCreature(shape, options);
      EXPECT_NEAR(length(posed) / length(rest), 1.0, 0.06) << "shape " << shape;
      double moved = 0.0;
      const vtkIdType last =
        std::min(posed.Skeleton->GetNumberOfPoints(), rest.Skeleton->GetNumberOfPoints()) - 1;
      for (vtkIdType n = 0; n <= last; ++n)
      {
        moved = std::max(moved,
          (Eigen::Vector3d(posed.Skeleton->GetPoint(n)) -
            Eigen::Vector3d(rest.Skeleton->GetPoint(n)))
            .norm());
      }
      EXPECT_GT(moved, 0.25) << "shape " << shape << " seed " << seed << " fell back to its rest";
    }
  }
}

TEST(CreaturePose, RestPoseIsSymmetric)
{
  // Left and right of a quadruped: the same skeleton mirrored in z.
  const Creature creature = MakeCreature(vtkCreatureSource::QUADRUPED);
  for (vtkIdType n = 0; n < creature.Skeleton->GetNumberOfPoints(); ++n)
  {
    Eigen::Vector3d mirrored(creature.Skeleton->GetPoint(n));
    mirrored.z() = -mirrored.z();
    double nearest = 1.0;
    for (vtkIdType m = 0; m < creature.Skeleton->GetNumberOfPoints(); ++m)
    {
      nearest =
        std::min(nearest, (Eigen::Vector3d(creature.Skeleton->GetPoint(m)) - mirrored).norm());
    }
    // A node is left out where it has no vertices, which depends on the triangulation.
    EXPECT_LT(nearest, 0.06) << "node " << n;
  }
}

TEST(CreatureSegments, LieWhereTheirNamesSay)
{
  const Creature creature = MakeCreature(vtkCreatureSource::QUADRUPED);
  TriangleMesh mesh;
  ToTriangleMesh(creature.Mesh, mesh);
  const std::vector<int> segments = SegmentsOf(creature);
  std::vector<Eigen::Vector3d> center(8, Eigen::Vector3d::Zero());
  std::vector<double> area(8, 0.0);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    center[segments[t]] += mesh.Area(t) * mesh.Centroid(t);
    area[segments[t]] += mesh.Area(t);
  }
  for (int s = 0; s < 8; ++s)
  {
    center[s] /= area[s];
  }
  enum
  {
    Torso,
    Neck,
    Head,
    FrontRight,
    FrontLeft,
    HindRight,
    HindLeft,
    Tail
  };
  EXPECT_GT(center[Head].x(), center[Neck].x());
  EXPECT_GT(center[Neck].x(), center[Torso].x());
  EXPECT_GT(center[Head].y(), center[Torso].y());
  EXPECT_LT(center[Tail].x(), center[HindRight].x());
  EXPECT_GT(center[FrontRight].x(), center[HindRight].x());
  EXPECT_GT(center[FrontRight].z(), 0.1);
  EXPECT_LT(center[FrontLeft].z(), -0.1);
  EXPECT_GT(center[HindRight].z(), 0.1);
  EXPECT_LT(center[HindLeft].z(), -0.1);
  EXPECT_LT(center[HindLeft].y(), center[Torso].y());
  EXPECT_EQ(std::max_element(area.begin(), area.end()) - area.begin(), Torso);
}

TEST(CreatureNoise, MovesVerticesByNoMoreThanAskedFor)
{
  CreatureOptions options;
  const Creature smooth = MakeCreature(vtkCreatureSource::BIPED, options);
  options.Noise = 0.002;
  const Creature noisy = MakeCreature(vtkCreatureSource::BIPED, options);
  TriangleMesh a;
  TriangleMesh b;
  ToTriangleMesh(smooth.Mesh, a);
  ToTriangleMesh(noisy.Mesh, b);
  ASSERT_EQ(a.Triangles, b.Triangles);
  EXPECT_EQ(SegmentsOf(smooth), SegmentsOf(noisy));
  double most = 0.0;
  for (int v = 0; v < a.NumberOfVertices(); ++v)
  {
    most = std::max(most, (a.Points[v] - b.Points[v]).norm());
  }
  const double limit = 0.002 * a.BoundingBoxDiagonal();
  EXPECT_LE(most, limit * (1.0 + 1e-9));
  EXPECT_GT(most, 0.9 * limit);
}

TEST(CreatureErrors, ThinLimbsLostAtALowResolution)
{
  vtkNew<vtkCreatureSource> source;
  const ErrorObserver errors(source);
  source->SetShape(vtkCreatureSource::OCTOPUS);
  source->SetProportion(1.0);
  source->SetSeed(2);
  source->SetResolution(2000);
  source->Update();
  EXPECT_TRUE(errors.HasError("The creature's thinnest limbs are lost at a resolution of 2000 "
                              "triangles: ask for more of them."))
    << errors.Text();
  EXPECT_EQ(source->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(source->GetOutput(1)->GetNumberOfPoints(), 0);
}
