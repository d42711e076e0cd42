// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MinimumSlicePerimeter_h
#define marrow_MinimumSlicePerimeter_h

#include "Progress.h"
#include "TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// Per vertex: the least slice perimeter, the centroid of that curve and the unit normal of its
/// plane (its sign means nothing), and 1 where that slice is closed by itself.
struct SliceField
{
  std::vector<double> Perimeter;
  std::vector<Eigen::Vector3d> Center;
  std::vector<Eigen::Vector3d> Normal;
  std::vector<unsigned char> Valid;
};

/// The MSP of every vertex (C:5, T:3.4): the least perimeter among `numberOfSlices` planes that
/// hold the vertex and its normal and are turned by π / numberOfSlices from one to the next.
///
/// The first plane is perpendicular to the direction in which the surface bends least, taken from
/// the dihedral angles of the edges around the vertex; where the surface is flat it follows the
/// direction from the centroid of the mesh. Both turn and scale with the mesh and know nothing of
/// the order of vertices. On a limb the first plane is thus the one across it.
///
/// Closed slices go before open ones, whatever their perimeter: an open slice closed by its chord
/// may be short only because the chord cuts across. Ties go to the plane of the lower index, so
/// that the result does not depend on the order of trying.
///
/// How steady it is: between 5k and 20k to 52k faces of one shape MSP differs by 1 to 3 % in the median
/// and 13 to 32 % at the 95th percentile, where the least slice jumps from one part to another.
/// Smoothing the normals first makes that worse on all shapes tried but a bumpy one; the least over
/// normals in a cone of 10° betters it by a tenth for two to three times the time. So the normals
/// are plain.
///
/// Vertices without any slice take the mean of the neighbours that have one, or have been filled
/// from theirs; where a whole component has none, perimeter 0 and the vertex itself.
///
/// Returns false when stopped.
bool ComputeMinimumSlicePerimeter(const TriangleMesh& mesh, int numberOfSlices, SliceField& field,
  const Progress& progress = Progress());
}

#endif
