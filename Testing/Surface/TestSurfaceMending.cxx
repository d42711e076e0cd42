// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceShapes.h"

#include <cmath>
#include <limits>

using namespace marrow;
using namespace marrow::test;

TEST(SurfaceMending, CleanMeshPassesBitForBit)
{
  for (const TriangleMesh& mesh : { MakeSphere(1.0, 3), MakeTorus(3.0, 1.0, 30, 15) })
  {
    const WorkingSurface surface = Compute(ToPolygons(mesh));
    EXPECT_TRUE(surface.IsInput);
    EXPECT_EQ(surface.Sentence(), "");
    ExpectSame(surface.Mesh, mesh);
    ExpectSame(surface.Full, mesh);
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      EXPECT_EQ(surface.TriangleOfCell(t), t);
    }
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      EXPECT_EQ(surface.VertexOfPoint[v], v);
      EXPECT_EQ(surface.PointOfVertex[v], v);
    }
  }
}

TEST(SurfaceMending, UnusedPointsPlayNoPart)
{
  const TriangleMesh sphere = MakeSphere(1.0, 2);
  PolygonMesh mesh = ToPolygons(sphere);
  // In front, so that everything is renumbered; and not finite, which is no matter in a point of no use.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.Points.insert(mesh.Points.begin(), Eigen::Vector3d(nan, nan, nan));
  for (int& corner : mesh.Corners)
  {
    ++corner;
  }
  const WorkingSurface surface = Compute(mesh);
  ExpectSame(surface.Mesh, sphere);
  EXPECT_EQ(surface.Report.UnusedPoints, 1);
  EXPECT_EQ(surface.VertexOfPoint.front(), -1);
  EXPECT_EQ(surface.VertexOfPoint[5], 4);
  EXPECT_EQ(surface.PointOfVertex[4], 5);
  EXPECT_EQ(surface.Sentence(), "left out 1 unused point");
}

TEST(SurfaceMending, OnlyUselessInputIsAnError)
{
  WorkingSurface surface;
  PolygonMesh mesh;
  EXPECT_EQ(
    ComputeWorkingSurface(mesh, {}, {}, surface), "The mesh has no face: connect a surface.");
  mesh = MakeCube();
  mesh.Points[3][1] = std::numeric_limits<double>::infinity();
  mesh.Points[6][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ComputeWorkingSurface(mesh, {}, {}, surface),
    "The mesh has 2 points in use whose coordinates are not finite (the first is point 3): remove "
    "or "
    "repair them.");
  mesh = MakeCube();
  mesh.Corners[9] = 8;
  EXPECT_EQ(ComputeWorkingSurface(mesh, {}, {}, surface),
    "The mesh has 1 face that names a point that does not exist (the first is cell 2): repair the "
    "cells.");
  mesh = {};
  mesh.Points.assign(3, Eigen::Vector3d::Ones());
  AddPolygon(mesh, { 0, 0, 2 });
  EXPECT_EQ(ComputeWorkingSurface(mesh, {}, {}, surface),
    "None of the mesh's faces has an area: connect a surface.");
}

TEST(SurfaceMending, SeamsAreSewn)
{
  const PolygonMesh cube = MakeCube();
  const WorkingSurface surface = Compute(Exploded(cube));
  ExpectSound(Exploded(cube), surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Mesh.NumberOfVertices(), 8);
  EXPECT_EQ(surface.Report.MergedPoints, 16);
  EXPECT_EQ(surface.Sentence(), "cut 6 polygons into triangles, merged 16 equal points");
  // Every copy of a point knows the vertex.
  for (int i = 0; i < 24; ++i)
  {
    EXPECT_EQ(surface.Mesh.Points[surface.VertexOfPoint[i]], cube.Points[cube.Corners[i]]);
  }
}

TEST(SurfaceMending, SeamsApartByRoundingAreSewnToo)
{
  // Coordinates as single precision has them far from the origin: neighbouring numbers 1/32 or 1/16 apart.
  PolygonMesh mesh = Exploded(MakeCube(Eigen::Vector3d(500000.0, 540000.0, 300.0), 16.0));
  std::mt19937 random(1);
  for (auto& point : mesh.Points)
  {
    const int axis = static_cast<int>(random() % 2);
    point[axis] += random() % 2 == 0 ? (axis == 0 ? 0.03125 : 0.0625) : 0.0;
  }
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Mesh.NumberOfVertices(), 8);
  // A real gap of a sixteenth of the cube is none of rounding.
  mesh = Exploded(MakeCube(Eigen::Vector3d(500000.0, 540000.0, 300.0), 16.0));
  for (int k = 0; k < 4; ++k)
  {
    mesh.Points[k] += Eigen::Vector3d(1.0, 0.0, 0.0);
  }
  EXPECT_EQ(Compute(mesh).Report.MergedPoints, 12);
}

TEST(SurfaceMending, PointsOfClosedSheetsStayTheirOwn)
{
  // Two spheres with a vertex in the same place: nothing is open there, and they do not grow together.
  PolygonMesh mesh = ToPolygons(MakeSphere(1.0, 3));
  Append(mesh, ToPolygons(Translated(MakeSphere(1.0, 3), { 2.0, 0.0, 0.0 })));
  const WorkingSurface surface = Compute(mesh);
  EXPECT_TRUE(surface.IsInput) << surface.Sentence();
  EXPECT_EQ(surface.NumberOfBodies, 2);
}

TEST(SurfaceMending, FacesThereTwiceCountOnce)
{
  PolygonMesh mesh = ToPolygons(MakeSphere(1.0, 2));
  const int faces = mesh.NumberOfPolygons();
  AddPolygon(mesh, { mesh.Corners[4], mesh.Corners[3], mesh.Corners[5] }); // face 1, turned round
  WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.FacesTwice, 1);
  EXPECT_EQ(surface.TriangleOfCell(faces), surface.TriangleOfCell(1));

  // A shell drawn from both sides, on the same points and on points of its own.
  const PolygonMesh front = ToPolygons(MakeSphere(1.0, 2));
  for (const bool sharesPoints : { true, false })
  {
    PolygonMesh both = front;
    PolygonMesh back = front;
    for (int c = 0; c < back.NumberOfPolygons(); ++c)
    {
      Flip(back, c);
    }
    Append(both, back);
    if (sharesPoints)
    {
      both.Points.resize(front.Points.size());
      for (int& corner : both.Corners)
      {
        corner %= front.NumberOfPoints();
      }
    }
    surface = Compute(both);
    ExpectSound(both, surface);
    ExpectClosed(surface, 0);
    EXPECT_EQ(surface.Mesh.NumberOfTriangles(), faces);
    EXPECT_EQ(surface.Report.FacesTwice, faces);
    EXPECT_EQ(surface.TriangleOfCell(faces + 7), surface.TriangleOfCell(7));
  }
}

TEST(SurfaceMending, APartWithoutAreaIsNoSurface)
{
  PolygonMesh line;
  line.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  AddPolygon(line, { 0, 1, 2 });
  WorkingSurface surface;
  EXPECT_EQ(ComputeWorkingSurface(line, {}, {}, surface),
    "None of the mesh's faces has an area: connect a surface.");

  // Beside a cube its face lies nearest to one of the cube's.
  PolygonMesh both = MakeCube({ 10, 0, 0 }, 1.0);
  const int numberOfFaces = both.NumberOfPolygons();
  Append(both, line);
  surface = Compute(both);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.FacesWithoutArea, 1);
  EXPECT_GE(surface.TriangleOfCell(numberOfFaces), 0);
}

TEST(SurfaceMending, FacesWithoutAreaGiveWay)
{
  // A point on an edge of a tetrahedron, and the triangle without area that fills the crack.
  PolygonMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 0, 0 } };
  AddPolygon(mesh, { 0, 2, 1 });
  AddPolygon(mesh, { 0, 4, 3 });
  AddPolygon(mesh, { 4, 1, 3 });
  AddPolygon(mesh, { 0, 1, 4 });
  AddPolygon(mesh, { 0, 3, 2 });
  AddPolygon(mesh, { 1, 2, 3 });
  AddPolygon(mesh, { 1, 1, 3 });
  AddPolygon(mesh, { 2, 3 });
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.FacesWithoutArea, 3);
  EXPECT_EQ(surface.Mesh.NumberOfTriangles(), 6);
  for (int t = 0; t < 6; ++t)
  {
    EXPECT_GT(surface.Mesh.Area(t), 0.5);
  }
}

TEST(SurfaceMending, EdgesOfNoLengthCollapse)
{
  TriangleMesh sphere = MakeSphere(1.0, 2);
  // A vertex moved onto its neighbour: the two triangles at their edge have no area.
  sphere.Points[sphere.To(0)] = sphere.Points[sphere.From(0)];
  const WorkingSurface surface = Compute(ToPolygons(sphere));
  ExpectSound(ToPolygons(sphere), surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.FacesWithoutArea, 2);
  EXPECT_EQ(surface.Mesh.NumberOfTriangles(), sphere.NumberOfTriangles() - 2);
}

TEST(SurfaceMending, FacesAreTurnedOutwards)
{
  PolygonMesh mesh = ToPolygons(MakeSphere(1.0, 3));
  const TriangleMesh clean = MakeSphere(1.0, 3);
  int turned = 0;
  std::mt19937 random(3);
  for (int c = 0; c < mesh.NumberOfPolygons(); ++c)
  {
    if (random() % 2 == 0)
    {
      Flip(mesh, c);
      ++turned;
    }
  }
  WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.TurnedFaces, turned);
  EXPECT_NEAR(SignedVolume(surface.Mesh), SignedVolume(clean), 1e-12);

  mesh = MakeCube();
  for (int c = 0; c < 6; ++c)
  {
    Flip(mesh, c);
  }
  surface = Compute(mesh);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.TurnedFaces, 6); // faces, not triangles
}

TEST(SurfaceMending, SheetsKeepTheSideOfMostOfTheirFaces)
{
  PolygonMesh mesh;
  for (int i = 0; i < 25; ++i)
  {
    const int row = i / 5;
    mesh.Points.push_back({ i % 5 * 1.0, row * 1.0, 0.0 });
  }
  for (int i = 0; i < 16; ++i)
  {
    const int p = i / 4 * 5 + i % 4;
    AddPolygon(mesh, { p, p + 5, p + 6, p + 1 }); // downwards
  }
  Flip(mesh, 3);
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  EXPECT_EQ(surface.Report.TurnedFaces, 1);
  for (int t = 0; t < surface.Mesh.NumberOfTriangles(); ++t)
  {
    EXPECT_LT(surface.Mesh.AreaVector(t)[2], 0.0);
  }
}

TEST(SurfaceMending, MoebiusStripIsCut)
{
  PolygonMesh mesh;
  const int around = 24;
  for (int i = 0; i < around; ++i)
  {
    const double u = 2.0 * Pi * i / around;
    for (const double side : { -0.3, 0.3 })
    {
      const double r = 1.0 + side * std::cos(0.5 * u);
      mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), side * std::sin(0.5 * u) });
    }
  }
  for (int i = 0; i + 1 < around; ++i)
  {
    AddPolygon(mesh, { 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 });
  }
  AddPolygon(mesh, { 2 * around - 2, 1, 0, 2 * around - 1 });
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  EXPECT_EQ(surface.Report.CutEdges, 1);
  EXPECT_EQ(surface.Full.NumberOfTriangles(), 2 * around);
  EXPECT_EQ(CheckMesh(surface.Mesh).NumberOfBorders, 1);
  EXPECT_EQ(CheckMesh(surface.Mesh).EulerCharacteristic, 1);
}

TEST(SurfaceMending, FinIsParted)
{
  TriangleMesh sphere = MakeSphere(1.0, 3);
  PolygonMesh mesh = ToPolygons(sphere);
  mesh.Points.push_back(1.2 * sphere.Points[0]);
  AddPolygon(mesh, { sphere.From(0), sphere.To(0), sphere.NumberOfVertices() });
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0); // the fin is a crumb
  EXPECT_EQ(surface.Report.SplitEdges, 1);
  EXPECT_EQ(surface.Mesh.Triangles, sphere.Triangles);
}

TEST(SurfaceMending, CubesThatShareAnEdgeStayClosed)
{
  PolygonMesh mesh = MakeCube();
  Append(mesh, MakeCube({ 1.0, 1.0, 0.0 }));
  // Points 3 and 7 of the first are points 0 and 4 of the second.
  for (int& corner : mesh.Corners)
  {
    corner = corner == 8 ? 3 : (corner == 12 ? 7 : corner);
  }
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  EXPECT_EQ(surface.Report.SplitEdges, 1);
  EXPECT_EQ(surface.Report.SplitPoints, 2);
  const MeshReport full = CheckMesh(surface.Full);
  EXPECT_EQ(full.NumberOfBorders, 0);
  EXPECT_EQ(full.NumberOfComponents, 2);
  EXPECT_NEAR(SignedVolume(surface.Full), 2.0, 1e-12);
}

TEST(SurfaceMending, PinchedPointIsParted)
{
  PolygonMesh mesh = ToPolygons(MakeSphere(1.0, 3));
  const int first = mesh.NumberOfPoints();
  Append(mesh, ToPolygons(Translated(MakeSphere(1.0, 3), { 2.0, 0.0, 0.0 })));
  for (int& corner : mesh.Corners)
  {
    corner = corner == first + 1 ? 0 : corner; // (1, 0, 0) of both
  }
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  ExpectClosed(surface, 0, 2);
  EXPECT_EQ(surface.Report.SplitPoints, 1);
}

TEST(SurfaceMending, SheetsJoinedAtBothEndsOfAnEdgeGetAPointBetween)
{
  // Two columns of cubes that touch along one edge, joined by cubes above and below it.
  const std::array<std::array<int, 3>, 8> filled{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 0, 1 }, { 1, 1, 1 }, { 0, 0, 2 }, { 1, 0, 2 }, { 1, 1, 2 } } };
  auto isFilled = [&](const std::array<int, 3>& cell)
  { return std::find(filled.begin(), filled.end(), cell) != filled.end(); };
  PolygonMesh mesh;
  for (int i = 0; i < 36; ++i)
  {
    const int row = i / 3 % 3;
    const int layer = i / 9;
    mesh.Points.push_back({ i % 3 * 1.0, row * 1.0, layer * 1.0 });
  }
  for (const auto& cell : filled)
  {
    const PolygonMesh cube = MakeCube();
    const std::array<std::array<int, 3>, 6> outward{ { { 0, 0, -1 }, { 0, 0, 1 }, { 0, -1, 0 },
      { 0, 1, 0 }, { -1, 0, 0 }, { 1, 0, 0 } } };
    for (int face = 0; face < 6; ++face)
    {
      if (isFilled(
            { cell[0] + outward[face][0], cell[1] + outward[face][1], cell[2] + outward[face][2] }))
      {
        continue;
      }
      std::vector<int> ids;
      for (int k = 0; k < 4; ++k)
      {
        const int corner = cube.CornersOf(face)[k];
        ids.push_back((cell[2] + (corner >> 2)) * 9 + (cell[1] + ((corner >> 1) & 1)) * 3 +
          cell[0] + (corner & 1));
      }
      AddPolygon(mesh, { ids[0], ids[1], ids[2], ids[3] });
    }
  }
  const WorkingSurface surface = Compute(mesh);
  ExpectSound(mesh, surface);
  EXPECT_EQ(surface.Report.SplitEdges, 1);
  EXPECT_EQ(CheckMesh(surface.Full).NumberOfBorders, 0);
  EXPECT_NEAR(SignedVolume(surface.Full), 8.0, 1e-12);
}

TEST(SurfaceMending, PinholesAreFilledAndOpeningsStay)
{
  PolygonMesh mesh = ToPolygons(MakeSphere(1.0, 4));
  PolygonMesh holed;
  holed.Points = mesh.Points;
  for (int c = 0; c < mesh.NumberOfPolygons(); ++c)
  {
    const Eigen::Vector3d& p = mesh.Points[mesh.CornersOf(c)[0]];
    if ((p - Eigen::Vector3d(0, 0, 1)).norm() > 0.2 && c != 700)
    {
      AddPolygon(holed, { mesh.CornersOf(c)[0], mesh.CornersOf(c)[1], mesh.CornersOf(c)[2] });
    }
  }
  WorkingSurface surface = Compute(holed);
  ExpectSound(holed, surface);
  ExpectClosed(surface, 0);
  EXPECT_EQ(surface.Report.FilledHoles, 2);
  EXPECT_GT(
    std::count(surface.CellOfFullTriangle.begin(), surface.CellOfFullTriangle.end(), -1), 1);

  // A tube without its caps, and half a sphere.
  const TriangleMesh tube = MakeCylinder(1.0, 10.0, 24, 60);
  PolygonMesh open;
  open.Points = tube.Points;
  for (const auto& t : tube.Triangles)
  {
    if (std::abs(tube.Points[t[0]][2]) < 4.9 || std::abs(tube.Points[t[1]][2]) < 4.9 ||
      std::abs(tube.Points[t[2]][2]) < 4.9)
    {
      AddPolygon(open, { t[0], t[1], t[2] });
    }
  }
  surface = Compute(open);
  EXPECT_EQ(surface.Report.FilledHoles, 0);
  EXPECT_EQ(CheckMesh(surface.Mesh).NumberOfBorders, 2);
  PolygonMesh bowl;
  bowl.Points = mesh.Points;
  for (int c = 0; c < mesh.NumberOfPolygons(); ++c)
  {
    const int* corners = mesh.CornersOf(c);
    if (mesh.Points[corners[0]][2] + mesh.Points[corners[1]][2] + mesh.Points[corners[2]][2] < 0.0)
    {
      AddPolygon(bowl, { corners[0], corners[1], corners[2] });
    }
  }
  surface = Compute(bowl);
  EXPECT_EQ(surface.Report.FilledHoles, 0);
  EXPECT_EQ(CheckMesh(surface.Mesh).NumberOfBorders, 1);
}
