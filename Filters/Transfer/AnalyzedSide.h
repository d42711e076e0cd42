// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnalyzedSide_h
#define marrow_AnalyzedSide_h

#include "AnalyzedMesh.h"
#include "MatchedSkeletons.h"
#include "PreparedSurface.h"
#include "Progress.h"

#include <string>
#include <vector>

class vtkPolyData;

/// From what is connected to vtkSegmentationTransfer to what the algorithms read, and back. Functions
/// return one sentence that says what is wrong, or an empty one.
namespace marrow
{
/// The source or the target: its surface, and what is known of each of its bodies.
struct AnalyzedSide
{
  PreparedSurface Surface;
  std::vector<AnalyzedMesh> Bodies; ///< as Surface.Bodies
};

/// What a connected skeleton says of its correspondence.
struct GivenCorrespondence
{
  std::vector<int> Nodes;    ///< per node; empty: nothing is said
  std::vector<int> Branches; ///< per branch
  CorrespondenceIds::ChainOrder Order;
  double Confidence = 1.0;

  bool IsKnown() const { return !this->Nodes.empty(); }
};

/// Measures and skeleton of a mesh: those that it brings with it, else by the defaults of vtkMSPField and
/// vtkMSPSkeleton. With a `skeleton` given, which belongs to the mesh as a whole, all bodies are one.
/// What `progress` stops is left unfinished.
std::string AnalyzeSide(
  vtkPolyData* mesh, vtkPolyData* skeleton, AnalyzedSide& side, const Progress& progress);

/// The arrays of vtkSkeletonCorrespondence, if the skeleton has them.
GivenCorrespondence ReadCorrespondence(vtkPolyData* skeleton);

/// The labels of the triangles of a body: the most area of the cells that became each.
std::vector<int> LabelsOfBody(
  const PreparedSurface& surface, const Body& body, const std::vector<int>& labelOfCell);
}

#endif
