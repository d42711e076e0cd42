// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkeletonMapper.h"

#include "vtkSkeletonGlyphs.h"

#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>

vtkStandardNewMacro(vtkSkeletonMapper);

vtkSkeletonMapper::vtkSkeletonMapper()
  : Glyphs(vtkSmartPointer<vtkSkeletonGlyphs>::New())
  , Surface(vtkSmartPointer<vtkPolyDataMapper>::New())
{
  this->Surface->SetInputConnection(this->Glyphs->GetOutputPort());
  this->Surface->SetScalarModeToUseCellData();
}

vtkSkeletonMapper::~vtkSkeletonMapper() = default;

vtkSkeletonGlyphs* vtkSkeletonMapper::GetGlyphs()
{
  return this->Glyphs;
}

int vtkSkeletonMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

bool vtkSkeletonMapper::UpdateSurface()
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

void vtkSkeletonMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->UpdateSurface())
  {
    this->Surface->Render(renderer, actor);
    this->TimeToDraw = this->Surface->GetTimeToDraw();
  }
}

void vtkSkeletonMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Surface->ReleaseGraphicsResources(window);
}

double* vtkSkeletonMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->UpdateSurface())
  {
    this->Surface->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

vtkMTimeType vtkSkeletonMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Glyphs->GetMTime());
}

bool vtkSkeletonMapper::HasOpaqueGeometry()
{
  return this->UpdateSurface() && this->Surface->HasOpaqueGeometry();
}

bool vtkSkeletonMapper::HasTranslucentPolygonalGeometry()
{
  return this->UpdateSurface() && this->Surface->HasTranslucentPolygonalGeometry();
}

void vtkSkeletonMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Glyphs:\n";
  this->Glyphs->PrintSelf(os, indent.GetNextIndent());
}
