// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelBridge_h
#define marrow_LabelBridge_h

#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataArray;

namespace marrow
{
/// Copies an array of one whole number for each of `size` cells (or points, `where`), in the range of an
/// int, whatever its type. Returns one sentence that says what is wrong, or an empty one.
std::string ToLabels(
  vtkDataArray* array, vtkIdType size, const char* where, std::vector<int>& labels);
}

#endif
