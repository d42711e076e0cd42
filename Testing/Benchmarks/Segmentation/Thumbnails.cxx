// SPDX-License-Identifier: BSD-3-Clause
#include "Thumbnails.h"

#include "ArrayNames.h"
#include "BenchmarkData.h"
#include "BenchmarkRun.h"
#include "FilterRun.h"
#include "MeshBridge.h"
#include "vtkMarrowMeshReader.h"
#include "vtkSideBySideScene.h"

#include <vtkCellData.h>
#include <vtkImageAppend.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& folder, int mesh)
{
  vtkNew<vtkMarrowMeshReader> reader;
  reader->SetFileName(MeshFile(folder, mesh).c_str());
  Run(reader);
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> Labelled(vtkPolyData* mesh, const std::vector<int>& labels)
{
  auto labelled = vtkSmartPointer<vtkPolyData>::New();
  labelled->ShallowCopy(mesh);
  SetIntArray(labelled->GetCellData(), names::SegmentId, labels);
  return labelled;
}

struct Tile
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::string Caption;
};

vtkSmartPointer<vtkImageData> DrawRow(const std::vector<Tile>& tiles)
{
  vtkNew<vtkSideBySideScene> scene;
  scene->SetTileWidth(300);
  scene->SetTileHeight(260);
  for (const Tile& tile : tiles)
  {
    scene->AddMesh(tile.Mesh, nullptr, tile.Caption.c_str());
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  if (!scene->Render(image))
  {
    throw std::runtime_error("The picture cannot be drawn.");
  }
  return image;
}
}

bool CanDraw()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

std::string DrawThumbnail(
  const std::string& dataFolder, const std::string& resultFolder, const Result& pair)
{
  const vtkSmartPointer<vtkPolyData> source = ReadMesh(dataFolder, pair.Source);
  const vtkSmartPointer<vtkPolyData> target = ReadMesh(dataFolder, pair.Target);
  const std::vector<int> sourceLabels =
    ReadLabels(dataFolder, pair.Source, source->GetNumberOfCells());
  const std::vector<int> sourcePieces =
    ReadPieces(dataFolder, pair.Source, source->GetNumberOfCells());
  std::map<int, int> labelOfPiece;
  for (std::size_t face = 0; face < sourcePieces.size(); ++face)
  {
    labelOfPiece[sourcePieces[face]] = sourceLabels[face];
  }
  std::vector<int> labels =
    ReadSegmentFile(BenchmarkRun::SegmentFile(resultFolder, pair), target->GetNumberOfCells());
  for (int& label : labels)
  {
    label = labelOfPiece[label];
  }

  const auto caption = [](const char* text, int mesh) { return text + std::to_string(mesh); };
  // What came out has a scene of its own: aligned with the others by its labels, wrong labels would
  // turn it. The same shape gives the same view.
  const auto truth =
    Labelled(target, ReadLabels(dataFolder, pair.Target, target->GetNumberOfCells()));
  vtkNew<vtkImageAppend> row;
  for (const auto& tiles :
    { std::vector<Tile>{ { truth, caption("as it should be: ", pair.Target) },
        { Labelled(source, sourceLabels), caption("source: ", pair.Source) } },
      std::vector<Tile>{ { Labelled(target, labels), "as it came out" } } })
  {
    row->AddInputData(DrawRow(tiles));
  }
  std::filesystem::create_directories(resultFolder + "/thumbnails");
  const std::string path = resultFolder + "/thumbnails/" + pair.Category + "_" +
    std::to_string(pair.Source) + "_" + std::to_string(pair.Target) + ".png";
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(row->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  return path;
}
}
