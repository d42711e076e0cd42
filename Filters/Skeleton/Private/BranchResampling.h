// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BranchResampling_h
#define marrow_BranchResampling_h

#include "Skeleton.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// A skeleton with the same branches whose regular nodes stand `spacing` apart. Every vertex goes to
/// the node nearest to its shrunk position, along the branch that it was collapsed to; so φ of a
/// regular node is a ring, and each node stands in the middle of its ring: at the mean of the shrunk
/// positions, weighted by `weight`. A removed limb (see PruneSpurs) stays in one piece: all of it goes
/// to the node that most of it is nearest to. A piece of a φ that does not hang together with the rest
/// goes to the node it borders on most.
Skeleton ResampleBranches(const Skeleton& skeleton, const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& shrunk, const std::vector<double>& weight,
  const std::vector<int>& removedLimb, double spacing);

/// Gives the nodes of `skeleton` the weighted mean of the shrunk positions of their φ.
void CenterNodes(Skeleton& skeleton, const std::vector<Eigen::Vector3d>& shrunk,
  const std::vector<double>& weight);

/// Takes the zigzag out of the branches: node positions are smoothed along them over a length in
/// proportion to the local radius MSP / 2π, the less the more surface stands behind a position.
void SmoothBranches(
  Skeleton& skeleton, const std::vector<double>& weight, const std::vector<double>& msp);

/// Moves each terminal from the middle of its cap towards the tip of the part. A removed limb next
/// to it is no part of the cap.
void ExtendTerminals(
  Skeleton& skeleton, const TriangleMesh& mesh, const std::vector<int>& removedLimb);
}

#endif
