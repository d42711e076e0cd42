// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowSegmentReader
 * @brief   put the segments of a .seg file on the cells of a mesh
 *
 * A .seg file, as the Princeton segmentation benchmark has them, is text with one integer a line: the
 * segment of face 0, of face 1, and so on. It may be compressed by gzip, begin with a byte order mark and
 * have any line ends. It says nothing without its mesh, so this reader is a filter.
 *
 * Input port 0: the mesh, vtkPolyData. Output port 0: the same points, cells and arrays, and
 * - cells, SegmentId (int): the file's integers, in the order of the cells; the only active
 *   scalars.
 *
 * Errors: no file name; the file cannot be read; a line is not one integer (its number is told); there
 * are more or fewer of them than cells (both numbers are told).
 */
#ifndef vtkMarrowSegmentReader_h
#define vtkMarrowSegmentReader_h

#include "MarrowIOModule.h"

#include <vtkPolyDataAlgorithm.h>

class MARROWIO_EXPORT vtkMarrowSegmentReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMarrowSegmentReader* New();
  vtkTypeMacro(vtkMarrowSegmentReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * The extensions of files that can be read, in lower case, separated by spaces.
   */
  static const char* GetFileExtensions();

protected:
  vtkMarrowSegmentReader() = default;
  ~vtkMarrowSegmentReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkMarrowSegmentReader(const vtkMarrowSegmentReader&) = delete;
  void operator=(const vtkMarrowSegmentReader&) = delete;
};

#endif
