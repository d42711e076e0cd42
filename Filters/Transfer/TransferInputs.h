// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TransferInputs_h
#define marrow_TransferInputs_h

#include "AnalyzedMesh.h"
#include "AnswerChoice.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkPolyData;

/// From what is connected to vtkSegmentationTransfer to what the algorithms read; what is not there
/// is computed by the filters of the earlier stages. Functions return one sentence that says what is
/// wrong, or an empty one.
namespace marrow
{
/// One mesh with its skeleton, as VTK holds it.
struct TransferSide
{
  std::string Role;                      ///< "Source" or "Target", for messages
  vtkSmartPointer<vtkPolyData> Mesh;     ///< with all arrays, after Complete
  vtkSmartPointer<vtkPolyData> Skeleton; ///< may be empty before Complete
};

/// Runs vtkMSPField and vtkMSPSkeleton inside `outer`, as far as needed, and fills `analyzed`.
std::string CompleteSide(
  vtkAlgorithm* outer, double from, double to, TransferSide& side, AnalyzedMesh& analyzed);

/// The answers that TransferSegmentation chooses from: the one that the skeletons bring with them, else
/// the best of MatchSkeletons with its defaults. None if `outer` is told to stop.
std::vector<Answer> FindAnswers(vtkAlgorithm* outer, double from, double to,
  const TransferSide& source, const AnalyzedMesh& sourceMesh, const TransferSide& target,
  const AnalyzedMesh& targetMesh);

/// The labels of the source's cells. `array` may be null: then the message names those there are.
std::string ReadLabels(
  vtkPolyData* mesh, vtkDataArray* array, const std::string& name, std::vector<int>& labels);
}

#endif
