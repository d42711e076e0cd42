// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOFFReader
 * @brief   read a surface from an OFF file as triangles
 *
 * Reads the ASCII Object File Format of Geomview: plain OFF and its variants with any of the prefixes
 * ST (texture coordinates), C (colours), N (normals) and 4 (homogeneous coordinates), comments, one
 * vertex or face a line. Binary and n-dimensional files are refused.
 *
 * Output: vtkPolyData of triangles. Points keep the file's order, and so do faces: a file of triangles
 * keeps its numbering. Faces of more corners are triangulated in place, by ear cutting; faces of fewer
 * than three corners are left out with a warning. Arrays, each only where the file has the data:
 * - points, Normals (double x 3, the active normals);
 * - points, Colors (unsigned char x 4, RGBA); colours written with a point are fractions of 1;
 * - points, TextureCoordinates (double x 2, the active texture coordinates);
 * - cells, Colors (unsigned char x 4, RGBA), if any face has a colour; grey for faces without;
 * - cells, OriginalCellId (vtkIdType): the face's number in the file, if cells are numbered otherwise.
 *
 * Errors, with the file's name and the line: no file name; the file cannot be read; it is not an OFF
 * file, or a binary one; it ends before the vertices or faces it promises; something is not a number;
 * a face uses a vertex that does not exist.
 */
#ifndef vtkOFFReader_h
#define vtkOFFReader_h

#include "MarrowSourcesModule.h"

#include <vtkPolyDataAlgorithm.h>

class MARROWSOURCES_EXPORT vtkOFFReader : public vtkPolyDataAlgorithm
{
public:
  static vtkOFFReader* New();
  vtkTypeMacro(vtkOFFReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkOFFReader();
  ~vtkOFFReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkOFFReader(const vtkOFFReader&) = delete;
  void operator=(const vtkOFFReader&) = delete;
};

#endif
