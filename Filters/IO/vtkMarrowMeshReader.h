// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowMeshReader
 * @brief   read a surface from a file, losing nothing
 *
 * Every face of the file becomes one polygon, in the file's order, so that a list of one label per face
 * fits whatever the format: polygons stay polygons, and faces without area or there twice stay too; those of
 * fewer than three corners repeat the last one up to three, as vtkPolyData needs. Coordinates are in double precision. The format follows from the name's ending:
 * - .off: text or binary, with any of the prefixes ST, C, N and 4;
 * - .ply: text, or binary of either byte order; properties of any type, further elements;
 * - .obj: polygons with any kind of corners and with indices from the end; materials need not be there;
 * - .stl: text or binary. The format repeats the corners of every facet: those of exactly equal
 *   coordinates become one point;
 * - .vtp, .vtu, .vtk: VTK's own, of any data set: polygons and strips of a surface, of a volume its
 *   outer surface. What is curved is taken by its corners, vertices and lines are left out.
 *
 * All but .vtp and .vtu may be compressed by gzip: .off.gz and so on. Text may have any line ends, a byte
 * order mark, and no end of the last line.
 *
 * Output: vtkPolyData with polygons only. Arrays, each only where the file has the data:
 * - points, Normals (float or double x 3, the active normals);
 * - points and cells, Colors (unsigned char x 4, RGBA); of cells grey where a face has none;
 * - points, TextureCoordinates (double x 2, the active texture coordinates);
 * - cells, GroupId (int), from the groups of .obj and the solids of .stl, ObjectId and MaterialId (int),
 *   from .obj: the number at the end of the names if they differ in nothing else ("leg1", "leg2"), else
 *   the name's place in the alphabet; and as field data GroupName, ObjectName, MaterialName (string): at
 *   i the name of what has the number i;
 * - cells, Attribute (unsigned short), from binary .stl;
 * - all other properties of .ply, and all arrays of VTK's files, in their own types.
 *
 * Errors, with the file's name and, where there is one, the line or byte: no file name, or none with a
 * known ending; the file cannot be read; it is not what its name says; it ends before what it promises;
 * something is not a number; a face uses a vertex that does not exist; it holds no surface; there is not
 * enough memory.
 */
#ifndef vtkMarrowMeshReader_h
#define vtkMarrowMeshReader_h

#include "MarrowIOModule.h"

#include <vtkPolyDataAlgorithm.h>

class MARROWIO_EXPORT vtkMarrowMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMarrowMeshReader* New();
  vtkTypeMacro(vtkMarrowMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * The extensions of files that can be read, in lower case, separated by spaces. Capital
   * letters are read too.
   */
  static const char* GetFileExtensions();

protected:
  vtkMarrowMeshReader();
  ~vtkMarrowMeshReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkMarrowMeshReader(const vtkMarrowMeshReader&) = delete;
  void operator=(const vtkMarrowMeshReader&) = delete;
};

#endif
