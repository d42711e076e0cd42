// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LinearAssignment_h
#define marrow_LinearAssignment_h

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// The assignment of rows to columns of least total cost (Hungarian method, O(n³)): per row its
/// column, or -1 where there are more rows than columns. A cost that is not finite is the worst.
std::vector<int> AssignRows(const Eigen::MatrixXd& cost);
}

#endif
