// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "MeshBridge.h"
#include "SideTransfer.h"
#include "SkeletonBridge.h"
#include "SkeletonFrame.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkIdList.h>
#include <vtkImageAppend.h>
#include <vtkImageConstantPad.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowMeshReader.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSegmentationTransfer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <stdexcept>

namespace figures
{
namespace
{
void Check(const std::string& error)
{
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
}

marrow::AnalyzedSide AnalyzeOneBody(vtkPolyData* mesh)
{
  marrow::AnalyzedSide side;
  Check(marrow::AnalyzeSide(mesh, nullptr, side, {}));
  return side;
}

/// The clean mesh of one body as its file has it, where the figures draw it: not in the canonical frame.
marrow::AnalyzedMesh InOwnFrame(vtkPolyData* mesh, const marrow::AnalyzedSide& side)
{
  const marrow::Body& body = side.Surface.Bodies.front();
  const marrow::AnalyzedMesh& framed = side.Bodies.front();
  marrow::AnalyzedMesh own;
  Check(marrow::ToTriangleMesh(mesh, own.Mesh));
  const std::size_t size = own.Mesh.Points.size();
  own.NodeOfVertex.resize(size);
  own.MSP.resize(size);
  own.GradientMagnitude.resize(size);
  own.DihedralAngle.resize(size);
  for (std::size_t v = 0; v < body.OriginalVertex.size(); ++v)
  {
    const int vertex = side.Surface.PointOf(body, static_cast<int>(v));
    own.NodeOfVertex[vertex] = framed.NodeOfVertex[v];
    own.MSP[vertex] = body.Frame.LengthFromFrame(framed.MSP[v]);
    own.GradientMagnitude[vertex] = framed.GradientMagnitude[v];
    own.DihedralAngle[vertex] = framed.DihedralAngle[v];
  }
  own.Skeleton = marrow::FromFrame(framed.Skeleton, body.Frame);
  marrow::SetNodeOfVertices(own.Skeleton, own.NodeOfVertex);
  return own;
}

/// Pictures side by side or one below the other, centred, on white.
Picture Joined(const std::vector<Picture>& pictures, int along)
{
  const int across = 1 - along;
  int most = 0;
  for (const Picture& picture : pictures)
  {
    most = std::max(most, picture->GetDimensions()[across]);
  }
  vtkNew<vtkImageAppend> append;
  append->SetAppendAxis(along);
  for (const Picture& picture : pictures)
  {
    const int* size = picture->GetDimensions();
    const int before = (most - size[across]) / 2;
    int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
    extent[2 * across] -= before;
    extent[2 * across + 1] = extent[2 * across] + most - 1;
    vtkNew<vtkImageConstantPad> pad;
    pad->SetInputData(picture);
    pad->SetConstant(255);
    pad->SetOutputWholeExtent(extent);
    append->AddInputConnection(pad->GetOutputPort());
  }
  append->Update();
  return append->GetOutput();
}
}

Data Creature(int shape, int seed, double pose, double proportion, int resolution)
{
  vtkNew<vtkCreatureSource> source;
  source->SetShape(shape);
  source->SetSeed(seed);
  source->SetPose(pose);
  source->SetProportion(proportion);
  source->SetResolution(resolution);
  source->Update();
  return source->GetOutput();
}

Data ReadMesh(const std::string& folder, const std::string& name)
{
  vtkNew<vtkMarrowMeshReader> reader;
  reader->SetFileName((folder + "/" + name + ".off").c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfCells() == 0)
  {
    Check(folder + "/" + name + ".off cannot be read: Examples/get-meshes.sh gets it.");
  }
  return reader->GetOutput();
}

Data Plain(vtkPolyData* mesh)
{
  auto plain = Data::New();
  plain->ShallowCopy(mesh);
  plain->GetCellData()->RemoveArray("SegmentId");
  return plain;
}

Data Output(vtkAlgorithm* filter, int port)
{
  auto copy = Data::New();
  copy->ShallowCopy(filter->GetOutputDataObject(port));
  return copy;
}

Prepared Prepare(vtkPolyData* mesh)
{
  vtkNew<vtkMSPSkeleton> skeleton;
  skeleton->SetInputData(mesh);
  skeleton->Update();
  return { Output(skeleton, 1), Output(skeleton, 0) };
}

marrow::AnalyzedMesh Analyze(vtkPolyData* mesh)
{
  return InOwnFrame(mesh, AnalyzeOneBody(mesh));
}

Matched MatchCreatures(vtkPolyData* source, vtkPolyData* target)
{
  Matched matched;
  matched.Source = Prepare(source);
  matched.Target = Prepare(target);
  const marrow::AnalyzedSide sourceSide = AnalyzeOneBody(matched.Source.Mesh);
  const marrow::AnalyzedSide targetSide = AnalyzeOneBody(matched.Target.Mesh);
  const marrow::Partner partner =
    marrow::FindPartner(sourceSide, targetSide.Bodies.front(), {}, {});
  matched.SourceMesh = InOwnFrame(source, sourceSide);
  matched.TargetMesh = InOwnFrame(target, targetSide);
  matched.Match = marrow::JoinChains(
    matched.SourceMesh.Skeleton, matched.TargetMesh.Skeleton, partner.Answers.front().Match.Ids);
  return matched;
}

Transferred Transfer(const Prepared& source, const Prepared& target, const TransferSettings& set)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source.Mesh);
  transfer->SetInputData(1, target.Mesh);
  transfer->SetInputData(2, source.Skeleton);
  transfer->SetInputData(3, target.Skeleton);
  set(transfer);
  transfer->Update();
  return { Output(transfer, 0), Output(transfer, 1), Output(transfer, 2) };
}

const Matched& Quadrupeds()
{
  static const Matched matched = MatchCreatures(
    Creature(vtkCreatureSource::QUADRUPED, 1), Creature(vtkCreatureSource::QUADRUPED, 7, 0.5, 0.5));
  return matched;
}

vtkSmartPointer<vtkMarrowSideBySideScene> Scene(int tileWidth, int tileHeight)
{
  auto scene = vtkSmartPointer<vtkMarrowSideBySideScene>::New();
  scene->SetTileWidth(tileWidth);
  scene->SetTileHeight(tileHeight);
  return scene;
}

Picture Drawn(vtkMarrowSideBySideScene* scene)
{
  auto picture = Picture::New();
  if (!scene->Render(picture))
  {
    Check("The scene cannot be drawn.");
  }
  return picture;
}

Picture Beside(const std::vector<Picture>& pictures)
{
  return Joined(pictures, 0);
}

Picture Below(const std::vector<Picture>& pictures)
{
  return Joined({ pictures.rbegin(), pictures.rend() }, 1);
}

std::vector<Eigen::Vector3d> PlacesOf(
  const marrow::TriangleMesh& mesh, const std::vector<int>& vertices)
{
  std::vector<Eigen::Vector3d> places;
  for (const int vertex : vertices)
  {
    places.push_back(mesh.Points[vertex]);
  }
  return places;
}

Data ClosedLine(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3d> closed = points;
  closed.push_back(points.front());
  return Line(closed);
}

Data Line(const std::vector<Eigen::Vector3d>& points)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(points.size()));
  for (const Eigen::Vector3d& point : points)
  {
    lines->InsertCellPoint(places->InsertNextPoint(point.data()));
  }
  auto line = Data::New();
  line->SetPoints(places);
  line->SetLines(lines);
  return line;
}

Data Segments(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& ends)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> lines;
  for (const auto& [from, to] : ends)
  {
    const vtkIdType first = places->InsertNextPoint(from.data());
    places->InsertNextPoint(to.data());
    lines->InsertNextCell({ first, first + 1 });
  }
  auto segments = Data::New();
  segments->SetPoints(places);
  segments->SetLines(lines);
  return segments;
}

vtkSmartPointer<vtkActor> Ball(const Eigen::Vector3d& center, double radius, const Color& color)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.x(), center.y(), center.z());
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

Data Faces(vtkPolyData* mesh, const std::function<bool(vtkIdType)>& isIn)
{
  auto part = Data::New();
  part->SetPoints(mesh->GetPoints());
  part->GetPointData()->ShallowCopy(mesh->GetPointData());
  part->GetCellData()->CopyAllocate(mesh->GetCellData());
  part->AllocateEstimate(mesh->GetNumberOfCells(), 3);
  for (vtkIdType face = 0; face < mesh->GetNumberOfCells(); ++face)
  {
    if (isIn(face))
    {
      const vtkIdType copy = part->InsertNextCell(VTK_TRIANGLE, mesh->GetCell(face)->GetPointIds());
      part->GetCellData()->CopyData(mesh->GetCellData(), face, copy);
    }
  }
  vtkNew<vtkCleanPolyData> used;
  used->SetInputData(part);
  used->PointMergingOff();
  used->Update();
  return Output(used);
}
}
