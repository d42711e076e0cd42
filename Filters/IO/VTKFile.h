// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_VTKFile_h
#define marrow_VTKFile_h

#include <vtkSmartPointer.h>

#include <string>

class vtkDataSet;

namespace marrow
{
/// Reads a file of VTK's own, XML whatever data set it holds, by VTK's readers, or of the older kind.
/// What VTK's filters would trip over is found. `content` is that of the file. Returns one
/// sentence that says what is wrong, or an empty one.
std::string ReadVTKFile(
  const std::string& content, const std::string& fileName, vtkSmartPointer<vtkDataSet>& data);
}

#endif
