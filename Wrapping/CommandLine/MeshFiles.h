// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshFiles_h
#define marrow_MeshFiles_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class Console;
class vtkDataObject;
class vtkPolyData;

/// Files in and out, the format chosen by the name's ending.
namespace files
{
/// What --labels takes, in words.
inline constexpr const char* LabelsHelp = "What in the mesh that holds them the segments are: the "
                                          "name of an array of cells or points or of a "
                                          "face property, or groups, objects, materials or colors";

/// Where the segments of a mesh come from.
struct SegmentSource
{
  /// A .seg file, or a mesh of the same faces that has labels; none: the mesh's own file.
  std::string File;
  /// What the labels are, in a file that is no .seg; see vtkMarrowSegmentSelector.
  std::string Labels = "SegmentId";
};

/// Reads a surface, of any format that vtkMarrowMeshReader reads.
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& path, Console& console);

/// The same with its segments in the cell array SegmentId.
vtkSmartPointer<vtkPolyData> ReadSegmented(
  const std::string& path, const SegmentSource& segments, Console& console);

/// Tells what was mended in a mesh to work on it, as the output of a filter says (WorkingSurfaceNote).
void ShowNote(vtkDataObject* output, const std::string& path, const Console& console);

/// Reads a .vtp or .vtk file as it is, a skeleton for example.
vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path, Console& console);

/// Writes a mesh or a skeleton in any format that vtkMarrowMeshWriter writes, or of a mesh the cell array
/// SegmentId to a .seg file.
void Write(vtkPolyData* data, const std::string& path, Console& console);

/// Writes a text file; throws CommandError if it cannot be written.
void WriteText(const std::string& path, const std::string& text);

/// The endings of what can be read as a mesh, and written as one with segments, for help texts.
std::string ReadableMeshes();
std::vector<std::string> WritableMeshes();
/// The latter without their dots, for --format.
std::vector<std::string> Formats();

/// The extension in lower case, with its dot: ".vtp".
std::string Extension(const std::string& path);

/// The name without folder and ending: "camel" of "data/camel.off.gz".
std::string Stem(const std::string& path);

/// Throws CommandError unless the ending is one of `allowed`.
void RequireExtension(const std::string& path, const std::vector<std::string>& allowed);

/// Throws CommandError unless the file can be written; asked before anything is computed.
void RequireWritable(const std::string& path);

/// Creates the folder if there is none.
void MakeFolder(const std::string& path);
}

#endif
