// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSegmentReader
 * @brief   put the segments of a .seg file on the cells of a mesh
 *
 * A .seg file, as the Princeton segmentation benchmark has them, is text with one integer a line: the
 * segment of face 0, of face 1, and so on. It says nothing without its mesh, so this reader is a
 * filter.
 *
 * Input port 0: the mesh, vtkPolyData. Output port 0: the same points, cells and arrays, and
 * - cells, SegmentId (int): the file's integers, in the order of the cells; the only active
 *   scalars.
 *
 * Errors: no file name; the file cannot be read; a line is not one integer (its number is told); there
 * are more or fewer of them than cells (both numbers are told).
 */
#ifndef vtkSegmentReader_h
#define vtkSegmentReader_h

#include "MarrowSourcesModule.h"

#include <vtkPolyDataAlgorithm.h>

class MARROWSOURCES_EXPORT vtkSegmentReader : public vtkPolyDataAlgorithm
{
public:
  static vtkSegmentReader* New();
  vtkTypeMacro(vtkSegmentReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkSegmentReader() = default;
  ~vtkSegmentReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkSegmentReader(const vtkSegmentReader&) = delete;
  void operator=(const vtkSegmentReader&) = delete;
};

#endif
