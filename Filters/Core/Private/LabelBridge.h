// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelBridge_h
#define marrow_LabelBridge_h

#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace marrow
{
/// Copies an array of one whole number for each of `size` cells (or points, `where`), in the range of an
/// int, whatever its type. Returns one sentence that says what is wrong, or an empty one.
std::string ToLabels(
  vtkDataArray* array, vtkIdType size, const char* where, std::vector<int>& labels);

/// The segments of a mesh's cells, by the cell array `array` that was chosen. That may be null, where there is
/// none of the name that was asked for: then the sentence names those there are.
std::string ReadLabels(
  vtkPolyData* mesh, vtkDataArray* array, const std::string& name, std::vector<int>& labels);
}

#endif
