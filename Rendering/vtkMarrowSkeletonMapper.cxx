// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarrowSkeletonMapper.h"

#include "vtkMarrowSkeletonGlyphs.h"

#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>

vtkStandardNewMacro(vtkMarrowSkeletonMapper);

vtkMarrowSkeletonMapper::vtkMarrowSkeletonMapper()
  : Glyphs(vtkSmartPointer<vtkMarrowSkeletonGlyphs>::New())
  , Surface(vtkSmartPointer<vtkPolyDataMapper>::New())
{
  this->Surface->SetInputConnection(this->Glyphs->GetOutputPort());
  this->Surface->SetScalarModeToUseCellData();
}

vtkMarrowSkeletonMapper::~vtkMarrowSkeletonMapper() = default;

vtkMarrowSkeletonGlyphs* vtkMarrowSkeletonMapper::GetGlyphs()
{
  return this->Glyphs;
}

int vtkMarrowSkeletonMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

bool vtkMarrowSkeletonMapper::UpdateSurface()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  // Not a connection: the glyphs would keep the upstream pipeline, and this mapper in it, alive.
  this->Glyphs->SetInputData(this->GetInputDataObject(0, 0));
  this->Surface->SetClippingPlanes(this->ClippingPlanes);
  return true;
}

void vtkMarrowSkeletonMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->UpdateSurface())
  {
    this->Surface->Render(renderer, actor);
    this->TimeToDraw = this->Surface->GetTimeToDraw();
  }
}

void vtkMarrowSkeletonMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Surface->ReleaseGraphicsResources(window);
}

double* vtkMarrowSkeletonMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->UpdateSurface())
  {
    this->Surface->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

vtkMTimeType vtkMarrowSkeletonMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Glyphs->GetMTime());
}

bool vtkMarrowSkeletonMapper::HasOpaqueGeometry()
{
  return this->UpdateSurface() && this->Surface->HasOpaqueGeometry();
}

bool vtkMarrowSkeletonMapper::HasTranslucentPolygonalGeometry()
{
  return this->UpdateSurface() && this->Surface->HasTranslucentPolygonalGeometry();
}

void vtkMarrowSkeletonMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Glyphs:\n";
  this->Glyphs->PrintSelf(os, indent.GetNextIndent());
}
