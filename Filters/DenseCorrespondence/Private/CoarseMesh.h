// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CoarseMesh_h
#define marrow_CoarseMesh_h

#include "AnalyzedMesh.h"

#include <vector>

namespace marrow
{
/// A mesh of few vertices in place of one of many, to try things out on.
///
/// The vertices are farthest-point samples along the edges of the fine mesh; a triangle stands where
/// the cells of three of them meet, so the surface is roughly, not strictly, a manifold. MSP is the
/// mean over a cell. The skeleton is the same, its φ the samples;
/// the slices are the same.
struct CoarseMesh
{
  AnalyzedMesh Side;
  std::vector<double> Shares; ///< per vertex: the area of its cell, of the whole; sum 1
  std::vector<int> Patches;   ///< per vertex: one of a few larger cells of even size
  int NumberOfPatches = 0;
  std::vector<int> CellOfVertex; ///< per vertex of the fine mesh; -1: no triangle uses it
  double Size = 0.0;             ///< root of the fine mesh's area
};

CoarseMesh Coarsen(const AnalyzedMesh& fine);
}

#endif
