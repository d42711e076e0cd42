// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LinearAssignment_h
#define marrow_LinearAssignment_h

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// The assignment of rows to columns of least total cost (Hungarian method, O(n³)): per row its
/// column, or -1 where there are more rows than columns. Costs are finite.
std::vector<int> AssignRows(const Eigen::MatrixXd& cost);
}

#endif
