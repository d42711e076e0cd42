// SPDX-License-Identifier: BSD-3-Clause
#include "SceneLinks.h"

#include "ArrayNames.h"
#include "vtkMarrowLabelColors.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace marrow
{
namespace
{
vtkDataArray* IdsOf(const SceneTile& tile)
{
  return tile.Skeleton ? tile.Skeleton->GetPointData()->GetArray(names::CorrespondenceId) : nullptr;
}

Eigen::Vector3d SeenPosition(const SceneTile& tile, vtkIdType node)
{
  return tile.Rotation * Eigen::Vector3d(tile.Skeleton->GetPoint(node));
}
}

SceneLinks::SceneLinks(
  const std::vector<SceneTile>& tiles, const std::vector<vtkRenderer*>& renderers)
{
  vtkDataArray* firstIds = IdsOf(tiles[0]);
  for (std::size_t i = 1; firstIds && i < tiles.size(); ++i)
  {
    vtkDataArray* ids = IdsOf(tiles[i]);
    for (vtkIdType a = 0; ids && a < firstIds->GetNumberOfTuples(); ++a)
    {
      const int id = static_cast<int>(firstIds->GetTuple1(a));
      for (vtkIdType b = 0; id >= 0 && b < ids->GetNumberOfTuples(); ++b)
      {
        if (static_cast<int>(ids->GetTuple1(b)) == id)
        {
          this->Ends.push_back({ renderers[0], SeenPosition(tiles[0], a) });
          this->Ends.push_back({ renderers[i], SeenPosition(tiles[i], b) });
          this->Ids.push_back(id);
        }
      }
    }
  }
}

void SceneLinks::AddTo(vtkRenderWindow* window, double lineWidth)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  this->Points->SetNumberOfPoints(static_cast<vtkIdType>(this->Ends.size()));
  for (std::size_t link = 0; link < this->Ids.size(); ++link)
  {
    const auto first = 2 * static_cast<vtkIdType>(link);
    lines->InsertNextCell({ first, first + 1 });
    double rgb[3];
    vtkMarrowLabelColors::GetColor(this->Ids[link], rgb);
    colors->InsertNextTuple3(255 * rgb[0], 255 * rgb[1], 255 * rgb[2]);
  }
  vtkNew<vtkPolyData> links;
  links->SetPoints(this->Points);
  links->SetLines(lines);
  links->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(links);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
  actor->GetProperty()->LightingOff();

  this->Overlay = vtkSmartPointer<vtkRenderer>::New();
  this->Overlay->SetLayer(1);
  this->Overlay->InteractiveOff();
  this->Overlay->AddActor(actor);
  this->Overlay->AddObserver(vtkCommand::StartEvent, this, &SceneLinks::Update);
  window->SetNumberOfLayers(2);
  window->AddRenderer(this->Overlay);
}

void SceneLinks::Update()
{
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    const End& end = this->Ends[i];
    end.Renderer->SetWorldPoint(end.Position.x(), end.Position.y(), end.Position.z(), 1.0);
    end.Renderer->WorldToDisplay();
    const double* place = end.Renderer->GetDisplayPoint();
    this->Points->SetPoint(static_cast<vtkIdType>(i), place[0], place[1], 0.0);
  }
  this->Points->Modified();
  // The overlay's world is the window in pixels.
  const int* size = this->Overlay->GetRenderWindow()->GetSize();
  vtkCamera* camera = this->Overlay->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.5 * size[0], 0.5 * size[1], 0.0);
  camera->SetPosition(0.5 * size[0], 0.5 * size[1], 1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.5 * size[1]);
  camera->SetClippingRange(0.1, 2.0);
}
}
