// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTimeSeriesTransfer
 * @brief   labels a mesh that changes over time, each step like the others
 *
 * A series of scans or of a simulation, whose mesh may be another one at every step: the steps are a
 * collection (vtkCollectionTransfer), so that they are labelled from those that are labelled and correct each
 * other, and a part has one label for all of time. Labelled is what a second input says, or steps that bring
 * labels of their own.
 *
 * When it is first asked for any time, the filter goes through all steps of its input and labels them all;
 * from then on each is there at once. All steps are held in memory. If the input or a parameter changes, it
 * goes through them anew, and what it has found out about steps that are as they were it still knows.
 *
 * Ports in:
 * - 0, the mesh over time: a vtkPolyData, any mesh will do, of a source that has time steps; of one without
 *   any, the one that there is;
 * - 1, labelled meshes of the same kind, vtkPolyData, any number of connections or none: each with the cell
 *   array "SegmentId" (any integers), or that set by SetInputArrayToProcess(0, 0, 0,
 *   vtkDataObject::FIELD_ASSOCIATION_CELLS, name), which holds for steps that are labelled too.
 *
 * Ports out:
 * - 0, the mesh at the time that is asked for, as vtkCollectionTransfer gives it: with the cell arrays
 *   SegmentId and SegmentConfidence;
 * - 1, a vtkTable, that of vtkCollectionTransfer: a row for each step, named "step 0" and so on, then one for each
 *   labelled mesh, "labelled 0" and so on.
 *
 * Errors: neither a step nor a second input has the array of segments; what vtkCollectionTransfer tells.
 *
 * @sa vtkCollectionTransfer
 */
#ifndef vtkTimeSeriesTransfer_h
#define vtkTimeSeriesTransfer_h

#include "MarrowCollectionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

class MARROWCOLLECTION_EXPORT vtkTimeSeriesTransfer : public vtkPolyDataAlgorithm
{
public:
  static vtkTimeSeriesTransfer* New();
  vtkTypeMacro(vtkTimeSeriesTransfer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * As vtkCollectionTransfer's: a folder, which must be there, in which what is found out about pairs of meshes
   * is kept for another run. Default none.
   */
  vtkSetFilePathMacro(CacheFolder);
  vtkGetFilePathMacro(CacheFolder);
  ///@}

  /**
   * Takes all labelled meshes (port 1) away again. The same as RemoveAllInputConnections(1), which ParaView cannot
   * call.
   */
  void RemoveLabelledMeshes();

protected:
  vtkTimeSeriesTransfer();
  ~vtkTimeSeriesTransfer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTimeSeriesTransfer(const vtkTimeSeriesTransfer&) = delete;
  void operator=(const vtkTimeSeriesTransfer&) = delete;

  /// Whether the labelled steps are those of the input as it is now.
  bool IsCurrent();
  bool Label(vtkInformationVector* labelled);

  char* CacheFolder = nullptr;

  struct Series;
  std::unique_ptr<Series> Steps;
};

#endif
