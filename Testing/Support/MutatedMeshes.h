// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_test_MutatedMeshes_h
#define marrow_test_MutatedMeshes_h

#include "SurfaceShapes.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <string>

namespace marrow::test
{
using Random = std::mt19937;

inline int Pick(Random& random, int size)
{
  return static_cast<int>(random() % static_cast<unsigned int>(size));
}

/// A copy of the polygons for which `keep` is true.
inline PolygonMesh Filtered(const PolygonMesh& mesh, const std::function<bool(int)>& keep)
{
  PolygonMesh result;
  result.Points = mesh.Points;
  for (int c = 0; c < mesh.NumberOfPolygons(); ++c)
  {
    if (keep(c))
    {
      result.Corners.insert(
        result.Corners.end(), mesh.CornersOf(c), mesh.CornersOf(c) + mesh.SizeOf(c));
      result.Offsets.push_back(static_cast<int>(result.Corners.size()));
    }
  }
  return result;
}

/// Does one of the things to a mesh that files have wrong, and says which.
inline void Mutate(PolygonMesh& mesh, Random& random, std::string& what)
{
  const int faces = mesh.NumberOfPolygons();
  if (faces == 0)
  {
    // The holes have taken all of it.
    return;
  }
  switch (Pick(random, 15))
  {
    case 0:
      what += " soup";
      mesh = Exploded(mesh);
      break;
    case 1:
      what += " flips";
      for (int i = Pick(random, faces); i >= 0; --i)
      {
        Flip(mesh, Pick(random, faces));
      }
      break;
    case 2:
      what += " holes";
      {
        const unsigned int share = 2 + random() % 50;
        mesh = Filtered(mesh, [&](int) { return random() % share != 0; });
      }
      break;
    case 3:
      what += " fins";
      for (int i = 0; i < 5; ++i)
      {
        const int* corners = mesh.CornersOf(Pick(random, faces));
        const int a = corners[0];
        const int b = corners[1];
        mesh.Points.push_back(mesh.Points[a] + Eigen::Vector3d(0.1, 0.2, 0.3));
        AddPolygon(mesh, { a, b, mesh.NumberOfPoints() - 1 });
      }
      break;
    case 4:
      what += " duplicates";
      for (int i = 0; i < 10; ++i)
      {
        const int c = Pick(random, faces);
        const int* corners = mesh.CornersOf(c);
        AddPolygon(mesh, { corners[1], corners[0], corners[2] });
      }
      break;
    case 5:
      what += " pinches";
      for (int i = 0; i < 3; ++i)
      {
        const int from = Pick(random, mesh.NumberOfPoints());
        const int to = Pick(random, mesh.NumberOfPoints());
        for (int& corner : mesh.Corners)
        {
          corner = corner == from ? to : corner;
        }
      }
      break;
    case 6:
      what += " crumbs";
      for (int i = 0; i < 4; ++i)
      {
        Append(mesh,
          ToPolygons(Translated(MakeSphere(0.01, 0), Eigen::Vector3d(i, Pick(random, 3), 1.0))));
      }
      break;
    case 7:
      what += " unit";
      {
        const double factor = std::pow(10.0, Pick(random, 61) - 30);
        for (auto& point : mesh.Points)
        {
          point *= factor;
        }
      }
      break;
    case 8:
      what += " twice";
      {
        PolygonMesh other = mesh;
        for (auto& point : other.Points)
        {
          point += Eigen::Vector3d(0.01 * Pick(random, 300), 0.0, 0.0);
        }
        Append(mesh, other);
      }
      break;
    case 9:
      what += " needles";
      for (int i = 0; i < 10; ++i)
      {
        const int* corners = mesh.CornersOf(Pick(random, faces));
        mesh.Points[corners[0]] = mesh.Points[corners[1]];
      }
      break;
    case 10:
      what += " single";
      for (auto& point : mesh.Points)
      {
        point = point.cast<float>().cast<double>();
      }
      break;
    case 11:
      what += " far";
      for (auto& point : mesh.Points)
      {
        point += Eigen::Vector3d(5.0e5, 5.0e6, 0.0);
      }
      break;
    case 12:
      what += " jagged";
      for (int i = 0; i < 10; ++i)
      {
        mesh.Points[Pick(random, mesh.NumberOfPoints())] +=
          Eigen::Vector3d(Pick(random, 3) - 1, Pick(random, 3) - 1, Pick(random, 3) - 1);
      }
      break;
    case 13:
      what += " NaN";
      mesh.Points[Pick(random, mesh.NumberOfPoints())][Pick(random, 3)] =
        std::numeric_limits<double>::quiet_NaN();
      break;
    default:
      what += " polygons";
      for (int i = 0; i < 10; ++i)
      {
        const int n = mesh.NumberOfPoints();
        AddPolygon(mesh,
          { Pick(random, n), Pick(random, n), Pick(random, n), Pick(random, n), Pick(random, n) });
      }
  }
}

/// A sound mesh of few faces to which up to four things were done, the same for each seed; `what` says which.
inline PolygonMesh MakeMutatedMesh(int seed, std::string& what)
{
  static const std::vector<PolygonMesh> bases = []
  {
    std::vector<PolygonMesh> meshes{ ToPolygons(MakeSphere(1.0, 2)), MakeCube(),
      ToPolygons(MakeTorus(3.0, 1.0, 20, 10)), ToPolygons(MakeCylinder(1.0, 5.0, 12, 10)) };
    for (const int shape : { vtkCreatureSource::BIPED, vtkCreatureSource::QUADRUPED })
    {
      TriangleMesh mesh;
      EXPECT_EQ(ToTriangleMesh(MakeCreature(shape).Mesh, mesh), "");
      // Fewer faces than vtkCreatureSource makes: thousands of such meshes are tried.
      WorkingSurfaceParameters parameters;
      parameters.MaximumFaces = 200;
      WorkingSurface surface;
      EXPECT_EQ(ComputeWorkingSurface(ToPolygons(mesh), parameters, {}, surface), "");
      meshes.push_back(ToPolygons(surface.Mesh));
    }
    return meshes;
  }();
  Random random(seed);
  PolygonMesh mesh = bases[seed % bases.size()];
  what = "seed " + std::to_string(seed) + ":";
  for (int i = Pick(random, 4); i >= 0; --i)
  {
    Mutate(mesh, random, what);
  }
  return mesh;
}

/// Whether a face has a corner whose coordinates are not numbers: the one defect that no mesh is mended of.
inline bool HasNaN(const PolygonMesh& mesh)
{
  return std::any_of(mesh.Corners.begin(), mesh.Corners.end(),
    [&](int corner) { return !mesh.Points[corner].allFinite(); });
}

/// The seeds that a test tries: MARROW_RANDOM_MESHES many from MARROW_FIRST_RANDOM_MESH on, or `usual` from 0 on.
struct MutatedMeshSeeds
{
  explicit MutatedMeshSeeds(int usual)
  {
    const char* count = std::getenv("MARROW_RANDOM_MESHES");
    const char* first = std::getenv("MARROW_FIRST_RANDOM_MESH");
    this->First = first ? std::atoi(first) : 0;
    this->End = this->First + (count ? std::atoi(count) : usual);
  }
  int First;
  int End;
};
}

#endif
