// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BestRotation_h
#define marrow_BestRotation_h

#include <Eigen/Core>

namespace marrow
{
/// The rotation that best carries t to s for a sum of s tᵀ; never a reflection.
Eigen::Matrix3d BestRotation(const Eigen::Matrix3d& covariance);
}

#endif
