// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarrowMeshWriter
 * @brief   write a mesh with its segments to a file
 *
 * The format follows from the name's ending, and with it where the segments go:
 * - .off: text; a colour per face, that of vtkMarrowLabelColors, or of the segment's name if that is one
 *   ("#ff0000"), and never the same for two segments;
 * - .ply: binary, little-endian; the face property SegmentId (int);
 * - .obj: text; a group per segment with the segment's name, or "segment_3" for number 3. Faces keep
 *   their order, so that a group may begin several times;
 * - .vtp, .vtk: VTK's own, binary, with all arrays.
 *
 * Read again by vtkMarrowMeshReader, the mesh has the same points, to the last bit, and the same faces,
 * and vtkMarrowSegmentSelector makes the same segments of the colours or groups.
 *
 * Input port 0: vtkPolyData; for formats not of VTK with polygons only. The segments are the cell array
 * SegmentId, of one integer per cell in the range of an int; SetInputArrayToProcess(0, 0, 0,
 * vtkDataObject::FIELD_ASSOCIATION_CELLS, name) selects another. Without that array the mesh is written
 * alone. The names of the segments are the field data SegmentName (string): at i that of segment i.
 *
 * A file appears under its name when it is complete, and not before. Errors: no file name, or none with
 * a known ending; cells that are no polygons, for formats not of VTK; segments that are no integers; the
 * file cannot be written. Write() then returns 0 and GetErrorCode() returns the kind.
 */
#ifndef vtkMarrowMeshWriter_h
#define vtkMarrowMeshWriter_h

#include "MarrowIOModule.h"

#include <vtkWriter.h>

class MARROWIO_EXPORT vtkMarrowMeshWriter : public vtkWriter
{
public:
  static vtkMarrowMeshWriter* New();
  vtkTypeMacro(vtkMarrowMeshWriter, vtkWriter);
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
  vtkMarrowMeshWriter();
  ~vtkMarrowMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkMarrowMeshWriter(const vtkMarrowMeshWriter&) = delete;
  void operator=(const vtkMarrowMeshWriter&) = delete;
};

#endif
