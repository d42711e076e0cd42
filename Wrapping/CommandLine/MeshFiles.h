// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshFiles_h
#define marrow_MeshFiles_h

#include <vtkSmartPointer.h>

#include <fstream>
#include <string>
#include <vector>

class Console;
class vtkPolyData;

/// Files in and out, the format chosen by the name's ending.
namespace files
{
/// Reads a surface as triangles: .off, .ply, .obj, .stl, .vtp, .vtk. The triangles of a file of
/// triangles keep its order, so that .seg files fit. Points that .stl and .obj repeat are merged.
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& path, Console& console);

/// Reads a .vtp or .vtk file as it is, a skeleton for example.
vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path, Console& console);

/// Reads one integer per face into the mesh's cell array SegmentId.
vtkSmartPointer<vtkPolyData> ReadSegments(
  vtkPolyData* mesh, const std::string& path, Console& console);

/// Writes a mesh or a skeleton with its arrays: .vtp or .vtk.
void WritePolyData(vtkPolyData* data, const std::string& path, Console& console);

/// Writes the cell array SegmentId, one integer per face.
void WriteSegments(vtkPolyData* mesh, const std::string& path, Console& console);

/// Opens a text file to be written anew.
std::ofstream Create(const std::string& path);

/// The ending with its dot, in small letters: ".vtp".
std::string Extension(const std::string& path);

/// The name without folder and ending: "camel" of "data/camel.off".
std::string Stem(const std::string& path);

/// Throws CommandError unless the ending is one of `allowed`.
void RequireExtension(const std::string& path, const std::vector<std::string>& allowed);

/// Throws CommandError unless the file can be written; asked before VTK's writers are, which differ in
/// what they say.
void RequireWritable(const std::string& path);

/// Creates the folder if there is none.
void MakeFolder(const std::string& path);
}

#endif
