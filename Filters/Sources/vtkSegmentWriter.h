// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSegmentWriter
 * @brief   write the segments of a mesh to a .seg file
 *
 * Writes one integer a line, the segment of cell 0, of cell 1, and so on: the file that
 * vtkSegmentReader reads.
 *
 * Input port 0: vtkPolyData with the segments in a cell array of one component whose values are
 * integers that an int holds. Default: SegmentId; SetInputArrayToProcess(0, 0, 0,
 * vtkDataObject::FIELD_ASSOCIATION_CELLS, name) selects another.
 *
 * Errors: no file name; no such array, or not one integer per cell; the file cannot be written. Write()
 * then returns 0 and GetErrorCode() tells the kind.
 */
#ifndef vtkSegmentWriter_h
#define vtkSegmentWriter_h

#include "MarrowSourcesModule.h"

#include <vtkWriter.h>

class MARROWSOURCES_EXPORT vtkSegmentWriter : public vtkWriter
{
public:
  static vtkSegmentWriter* New();
  vtkTypeMacro(vtkSegmentWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkSegmentWriter();
  ~vtkSegmentWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkSegmentWriter(const vtkSegmentWriter&) = delete;
  void operator=(const vtkSegmentWriter&) = delete;
};

#endif
