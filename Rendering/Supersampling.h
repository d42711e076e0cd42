// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Supersampling_h
#define marrow_Supersampling_h

class vtkImageData;
class vtkRenderWindow;

namespace marrow
{
/// The window of a picture is drawn larger by this factor and averaged: smooth edges that do not
/// depend on what the graphics driver offers.
inline constexpr int Supersampling = 2;

/// Draws a window that was made Supersampling times as large as the picture, offscreen, and gives
/// the picture (RGB, unsigned char).
void DrawSupersampled(vtkRenderWindow* window, vtkImageData* picture);
}

#endif
