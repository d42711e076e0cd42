// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CollectionFolder_h
#define marrow_CollectionFolder_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class Console;
class vtkPolyData;

/// A mesh file of a folder.
struct CollectionEntry
{
  std::string Name;                  ///< without folder and ending
  std::string File;                  ///< with the folder
  std::string Segments;              ///< the segment file beside it; empty: none
  std::string Error;                 ///< why it cannot be used; empty: it can
  vtkSmartPointer<vtkPolyData> Mesh; ///< with the cell array SegmentId if it is labelled
};

/// All meshes of a folder by name, read; the folders in it are left alone. A mesh with a segment file
/// of its name beside it, or with labels of its own (`labels` as for --labels; empty: a cell array SegmentId),
/// is labelled. What cannot be read has an Error.
std::vector<CollectionEntry> ReadCollection(
  const std::string& folder, const std::string& labels, Console& console);

#endif
