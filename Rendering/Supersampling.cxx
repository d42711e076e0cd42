// SPDX-License-Identifier: BSD-3-Clause
#include "Supersampling.h"

#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

namespace marrow
{
void DrawSupersampled(vtkRenderWindow* window, vtkImageData* picture)
{
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->Render();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(capture->GetOutputPort());
  shrink->SetShrinkFactors(Supersampling, Supersampling, 1);
  shrink->MeanOn();
  shrink->Update();
  picture->ShallowCopy(shrink->GetOutput());
}
}
