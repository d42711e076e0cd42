// SPDX-License-Identifier: BSD-3-Clause
// Click on a branch of the skeleton, and the part of the surface that belongs to it lights up.
//   PickBranch                   opens a window
//   PickBranch picture.png X Y   clicks at pixel X, Y without one and writes what is then seen
#include <vtkActor.h>
#include <vtkCellPicker.h>
#include <vtkCreatureSource.h>
#include <vtkIdList.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdlib>
#include <iostream>
#include <set>

struct BranchPicker
{
  vtkPolyData* Skeleton;
  vtkPolyData* Surface;
  vtkRenderer* Renderer;
  vtkRenderWindowInteractor* Interactor;
  vtkNew<vtkPolyData> Lit;

  void Pick()
  {
    const int* place = this->Interactor->GetEventPosition();
    vtkNew<vtkCellPicker> picker;
    picker->SetTolerance(0.01);
    if (!picker->Pick(
          place[0], place[1], 0.0, this->Renderer)) // a transparent surface lets it through
    {
      std::cout << "No branch there\n";
      return;
    }
    const vtkIdType branch = picker->GetCellId(); // the skeleton has a polyline for each branch
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    this->Skeleton->GetCellPoints(branch, size, ids);
    std::set<vtkIdType> nodes(ids, ids + size);
    vtkDataArray* types = this->Skeleton->GetPointData()->GetArray("NodeType");
    for (const vtkIdType end : { ids[0], ids[size - 1] })
    {
      if (types->GetTuple1(end) == 3) // a junction belongs to no branch alone
      {
        nodes.erase(end);
      }
    }
    std::cout << "Branch " << branch << " of " << size << " nodes\n";

    vtkDataArray* nodeOfVertex = this->Surface->GetPointData()->GetArray("SkeletonNodeId");
    vtkNew<vtkCellArray> faces;
    for (vtkIdType face = 0; face < this->Surface->GetNumberOfCells(); ++face)
    {
      vtkIdList* corners = this->Surface->GetCell(face)->GetPointIds();
      if (nodes.count(static_cast<vtkIdType>(nodeOfVertex->GetTuple1(corners->GetId(0)))) > 0)
      {
        faces->InsertNextCell(corners);
      }
    }
    this->Lit->SetPolys(faces);
    this->Interactor->GetRenderWindow()->Render();
  }
};

int main(int argc, char* argv[])
{
  vtkNew<vtkCreatureSource> creature;
  vtkNew<vtkMSPSkeleton> filter;
  filter->SetInputConnection(creature->GetOutputPort());
  filter->Update();

  BranchPicker branches;
  branches.Skeleton = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  branches.Surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  branches.Lit->SetPoints(branches.Surface->GetPoints());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(branches.Lit);
  vtkNew<vtkActor> lit;
  lit->SetMapper(mapper);
  lit->PickableOff();
  lit->GetProperty()->SetColor(0.9, 0.6, 0.0);
  lit->GetProperty()->SetOpacity(0.5);

  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetTileWidth(500);
  scene->SetSurfaceOpacity(0.2);
  scene->SetLabelArrayName("");
  scene->AddActor(scene->AddMesh(branches.Surface, branches.Skeleton), lit);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(argc > 3);
  scene->AddTo(window);
  branches.Renderer = scene->GetRenderer(0);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  branches.Interactor = interactor;
  interactor->AddObserver(vtkCommand::LeftButtonPressEvent, &branches, &BranchPicker::Pick);
  window->Render();
  if (argc <= 3)
  {
    interactor->Start();
    return 0;
  }
  interactor->SetEventPosition(std::atoi(argv[2]), std::atoi(argv[3]));
  interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  return scene->WritePNG(argv[1]) ? 0 : 1;
}
