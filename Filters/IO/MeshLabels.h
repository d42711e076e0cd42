// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshLabels_h
#define marrow_MeshLabels_h

#include <string>
#include <vector>

class vtkPolyData;

namespace marrow
{
struct MeshLabels
{
  std::vector<int> Ids;              ///< per cell
  std::vector<std::string> NameOfId; ///< empty if there are no names
};

/// The labels that vtkMarrowSegmentSelector describes. Returns one sentence that says what is wrong, or
/// an empty one.
std::string SelectLabels(vtkPolyData* mesh, const std::string& name, MeshLabels& labels);
}

#endif
