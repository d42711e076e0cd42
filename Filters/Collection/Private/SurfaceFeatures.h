// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceFeatures_h
#define marrow_SurfaceFeatures_h

#include "AnalyzedMesh.h"

#include <Eigen/Core>

namespace marrow
{
/// What tells the places of a surface apart, per vertex (row): AGD, MSP and its gradient, the dihedral angle,
/// the distance from the skeleton; of the node and its branch their measures and the place along the branch;
/// where the vertex lies and which way it faces, by the principal axes, but not on which side of them; and at
/// several scales how far the surface bends away, how it extends, and MSP and AGD around. Nothing of it
/// depends on size, place or direction. `shape` is in its canonical frame.
Eigen::MatrixXf SurfaceFeatures(const AnalyzedMesh& shape);
}

#endif
