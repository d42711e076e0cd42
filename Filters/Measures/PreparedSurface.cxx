// SPDX-License-Identifier: BSD-3-Clause
#include "PreparedSurface.h"

#include "ArrayNames.h"
#include "CanonicalOrder.h"
#include "InputCheck.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"
#include "SkeletonFrame.h"
#include "SurfaceBridge.h"

#include <vtkMSPField.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace marrow
{
namespace
{
/// The triangles of one body and the vertices that they use, in the order of the working surface.
template <typename IsPart>
Body ExtractBody(const WorkingSurface& working, IsPart&& isPart)
{
  TriangleMesh part;
  std::vector<int> vertices;
  std::vector<int> triangles;
  std::vector<int> rank(working.Mesh.Points.size(), -1);
  for (int t = 0; t < working.Mesh.NumberOfTriangles(); ++t)
  {
    if (!isPart(t))
    {
      continue;
    }
    triangles.push_back(t);
    std::array<int, 3> corners = working.Mesh.Triangles[t];
    for (int& corner : corners)
    {
      if (rank[corner] < 0)
      {
        rank[corner] = static_cast<int>(vertices.size());
        vertices.push_back(corner);
        part.Points.push_back(working.Mesh.Points[corner]);
      }
      corner = rank[corner];
    }
    part.Triangles.push_back(corners);
  }
  Body body = ToCanonicalMesh(part);
  for (int& vertex : body.OriginalVertex)
  {
    vertex = vertices[vertex];
  }
  for (int& triangle : body.OriginalTriangle)
  {
    triangle = triangles[triangle];
  }
  return body;
}

std::string NotFinite(const char* name, int point)
{
  return std::string("The array \"") + name + "\" of the mesh is not finite at point " +
    std::to_string(point) + ": remove the array, and it is computed anew.";
}

bool IsFinite(double value)
{
  return std::isfinite(value);
}

bool IsFinite(const Eigen::Vector3d& value)
{
  return value.allFinite();
}

bool IsFinite(unsigned char)
{
  return true;
}

template <typename Value, typename Convert>
std::string Gather(vtkPolyData* input, const char* name, const PreparedSurface& surface,
  const Body& body, std::vector<Value>& values, Convert&& convert)
{
  values.clear();
  std::vector<Value> atPoints;
  if (!GetArray(
        input->GetPointData(), name, static_cast<int>(input->GetNumberOfPoints()), atPoints))
  {
    return {};
  }
  values.reserve(body.Mesh.Points.size());
  for (int v = 0; v < body.Mesh.NumberOfVertices(); ++v)
  {
    const int point = surface.PointOf(body, v);
    if (!IsFinite(atPoints[point]))
    {
      return NotFinite(name, point);
    }
    values.push_back(convert(atPoints[point]));
  }
  return {};
}

double Zero(double)
{
  return 0.0;
}

unsigned char Zero(unsigned char)
{
  return 0;
}

Eigen::Vector3d Zero(const Eigen::Vector3d&)
{
  return Eigen::Vector3d::Zero();
}

template <typename Value, typename Convert>
void Scatter(const PreparedSurface& surface, const std::vector<VertexMeasures>& ofBodies,
  std::vector<Value> VertexMeasures::*member, const char* name, std::vector<Value> atPoints,
  vtkPolyData* output, Convert&& convert)
{
  const Value none = Zero(Value(atPoints.front()));
  // Every vertex belongs to a body.
  std::vector<Value> atVertices(surface.Working.Mesh.Points.size(), none);
  for (std::size_t b = 0; b < ofBodies.size(); ++b)
  {
    const Body& body = surface.Bodies[b];
    for (int v = 0; v < body.Mesh.NumberOfVertices(); ++v)
    {
      atVertices[body.OriginalVertex[v]] = convert(body.Frame, (ofBodies[b].*member)[v]);
    }
  }
  for (std::size_t p = 0; p < atPoints.size(); ++p)
  {
    const int vertex = surface.Working.VertexOfPoint[p];
    if (vertex >= 0)
    {
      atPoints[p] = atVertices[vertex];
    }
  }
  SetArray(output->GetPointData(), name, atPoints);
}
}

namespace
{
/// Turns what the working surface says of points back to the numbers that they had.
void RestorePoints(const std::vector<int>& originalPoint, WorkingSurface& working)
{
  std::vector<int> vertexOfPoint(originalPoint.size());
  for (std::size_t i = 0; i < originalPoint.size(); ++i)
  {
    vertexOfPoint[originalPoint[i]] = working.VertexOfPoint[i];
  }
  working.VertexOfPoint = std::move(vertexOfPoint);
  for (std::vector<int>* points : { &working.PointOfVertex, &working.PointOfFullVertex })
  {
    for (int& point : *points)
    {
      point = originalPoint[point];
    }
  }
}
}

std::string PrepareSurface(vtkPolyData* input, int maximumFaces, BodyMode mode,
  PreparedSurface& surface, const Progress& progress)
{
  surface = PreparedSurface();
  SurfaceOfPolyData faces = ToPolygonMesh(input);
  WorkingSurfaceParameters parameters;
  parameters.MaximumFaces = maximumFaces > 0 ? maximumFaces : std::numeric_limits<int>::max();
  // Before anything is put in another order: the message numbers as the input does.
  std::string error = CheckInput(faces.Mesh);
  if (!error.empty())
  {
    return error;
  }
  const CanonicalPolygons canonical = InCanonicalOrder(faces.Mesh);
  error = ComputeWorkingSurface(canonical.Mesh, parameters, progress, surface.Working);
  if (!error.empty() || !Report(progress, 1.0))
  {
    return error;
  }
  RestorePoints(canonical.OriginalPoint, surface.Working);
  for (int polygon : canonical.OriginalPolygon)
  {
    surface.CellOfPolygon.push_back(faces.CellOfPolygon[polygon]);
  }
  surface.NumberOfCells = static_cast<int>(input->GetNumberOfCells());
  surface.Working.Report.OtherCells = faces.NumberOfOtherCells;
  const int numberOfBodies = mode == BodyMode::Together ? 1 : surface.Working.NumberOfBodies;
  for (int number = 0; number < numberOfBodies; ++number)
  {
    surface.Bodies.push_back(ExtractBody(surface.Working,
      [&](int triangle) {
        return mode == BodyMode::Together || surface.Working.BodyOfTriangle[triangle] == number;
      }));
  }
  return {};
}

std::string ReadMeasures(
  vtkPolyData* input, const PreparedSurface& surface, const Body& body, VertexMeasures& measures)
{
  const CanonicalFrame& frame = body.Frame;
  const auto same = [](auto value) { return value; };
  const auto length = [&](double value) { return frame.LengthToFrame(value); };
  const auto position = [&](const Eigen::Vector3d& value) { return frame.ToFrame(value); };
  const auto direction = [&](const Eigen::Vector3d& value)
  { return frame.DirectionToFrame(value); };
  std::string error;
  const auto gather = [&](const char* name, auto& values, const auto& convert)
  { error = error.empty() ? Gather(input, name, surface, body, values, convert) : error; };
  gather(names::AGD, measures.AGD, same);
  gather(names::MSP, measures.MSP, length);
  gather(names::MSPCenter, measures.MSPCenter, position);
  gather(names::MSPNormal, measures.MSPNormal, direction);
  gather(names::MSPGradient, measures.MSPGradient, direction);
  gather(names::MSPValid, measures.MSPValid, same);
  gather(names::DihedralAngle, measures.DihedralAngle, same);
  return error;
}

bool MeasureBody(const Body& body, const MeasureParameters& parameters, VertexMeasures& measures,
  const Progress& progress)
{
  if (!MeasureMesh(body.Mesh, parameters, measures, progress))
  {
    return false;
  }
  // What is written to arrays and read back from them is then the same.
  for (double& length : measures.MSP)
  {
    length = CanonicalFrame::ToGrid(length);
  }
  for (Eigen::Vector3d& center : measures.MSPCenter)
  {
    center = CanonicalFrame::ToGrid(center);
  }
  return true;
}

MeasureParameters DefaultMeasureParameters()
{
  vtkNew<vtkMSPField> field;
  return { field->GetNumberOfSlices(),
    field->GetAGDMethod() == vtkMSPField::ALL_PAIRS ? GeodesicSources::AllVertices
                                                    : GeodesicSources::Sampled };
}

void WriteNote(const PreparedSurface& surface, vtkPolyData* output)
{
  const std::string note = surface.Working.Sentence();
  if (!note.empty())
  {
    SetNote(note, output);
  }
}

void WriteMeasures(
  const PreparedSurface& surface, const std::vector<VertexMeasures>& ofBodies, vtkPolyData* output)
{
  const std::size_t size = static_cast<std::size_t>(output->GetNumberOfPoints());
  const std::vector<double> noNumber(size, 0.0);
  const std::vector<Eigen::Vector3d> noVector(size, Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3d> positions(size);
  for (std::size_t p = 0; p < size; ++p)
  {
    output->GetPoint(static_cast<vtkIdType>(p), positions[p].data());
  }
  const auto same = [](const CanonicalFrame&, auto value) { return value; };
  const auto length = [](const CanonicalFrame& frame, double value)
  { return frame.LengthFromFrame(value); };
  const auto position = [](const CanonicalFrame& frame, const Eigen::Vector3d& value)
  { return frame.FromFrame(value); };
  const auto direction = [](const CanonicalFrame& frame, const Eigen::Vector3d& value)
  { return frame.DirectionFromFrame(value); };
  using M = VertexMeasures;
  Scatter(surface, ofBodies, &M::AGD, names::AGD, noNumber, output, same);
  Scatter(surface, ofBodies, &M::MSP, names::MSP, noNumber, output, length);
  Scatter(surface, ofBodies, &M::MSPCenter, names::MSPCenter, positions, output, position);
  Scatter(surface, ofBodies, &M::MSPNormal, names::MSPNormal, noVector, output, direction);
  Scatter(surface, ofBodies, &M::MSPValid, names::MSPValid, std::vector<unsigned char>(size, 0),
    output, same);
  Scatter(surface, ofBodies, &M::MSPGradient, names::MSPGradient, noVector, output, direction);
  Scatter(surface, ofBodies, &M::DihedralAngle, names::DihedralAngle, noNumber, output, same);
}

void WriteSkeletons(const PreparedSurface& surface, const std::vector<Skeleton>& ofBodies,
  vtkPolyData* skeleton, vtkPolyData* mesh)
{
  Skeleton whole;
  std::vector<int> nodeOfVertex(surface.Working.Mesh.Points.size(), -1);
  for (std::size_t b = 0; b < ofBodies.size(); ++b)
  {
    const Body& body = surface.Bodies[b];
    const int firstNode = whole.NumberOfNodes();
    const std::vector<int> nodeInBody = NodeOfVertices(ofBodies[b], body.Mesh.NumberOfVertices());
    for (int v = 0; v < body.Mesh.NumberOfVertices(); ++v)
    {
      nodeOfVertex[body.OriginalVertex[v]] = nodeInBody[v] < 0 ? -1 : firstNode + nodeInBody[v];
    }
    Append(whole, FromFrame(ofBodies[b], body.Frame));
  }
  std::vector<int> nodeOfPoint(surface.Working.VertexOfPoint.size(), -1);
  for (std::size_t p = 0; p < nodeOfPoint.size(); ++p)
  {
    const int vertex = surface.Working.VertexOfPoint[p];
    nodeOfPoint[p] = vertex < 0 ? -1 : nodeOfVertex[vertex];
  }
  ToPolyData(whole, skeleton);
  SetIdArray(mesh->GetPointData(), names::SkeletonNodeId, nodeOfPoint);
}
}
