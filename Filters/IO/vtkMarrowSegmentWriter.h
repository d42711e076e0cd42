// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowSegmentWriter
 * @brief   write the segments of a mesh to a .seg file
 *
 * Writes one integer a line, the segment of cell 0, of cell 1, and so on: the file that
 * vtkMarrowSegmentReader reads. It appears under its name when it is complete, and not before.
 *
 * Input port 0: vtkPolyData with the segments in a cell array of one component whose values are
 * integers that an int holds. Default: SegmentId; SetInputArrayToProcess(0, 0, 0,
 * vtkDataObject::FIELD_ASSOCIATION_CELLS, name) selects another.
 *
 * Errors: no file name; no such array, or not one integer per cell; the file cannot be written. Write()
 * then returns 0 and GetErrorCode() returns the kind.
 */
#ifndef vtkMarrowSegmentWriter_h
#define vtkMarrowSegmentWriter_h

#include "MarrowIOModule.h"

#include <vtkWriter.h>

class MARROWIO_EXPORT vtkMarrowSegmentWriter : public vtkWriter
{
public:
  static vtkMarrowSegmentWriter* New();
  vtkTypeMacro(vtkMarrowSegmentWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * The extensions of files that can be written, in lower case, separated by spaces.
   */
  static const char* GetFileExtensions();

protected:
  vtkMarrowSegmentWriter();
  ~vtkMarrowSegmentWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkMarrowSegmentWriter(const vtkMarrowSegmentWriter&) = delete;
  void operator=(const vtkMarrowSegmentWriter&) = delete;
};

#endif
