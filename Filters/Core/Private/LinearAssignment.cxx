// SPDX-License-Identifier: BSD-3-Clause
#include "LinearAssignment.h"

#include <cmath>
#include <limits>

namespace marrow
{
std::vector<int> AssignRows(const Eigen::MatrixXd& given)
{
  /// Of what is no number or infinite: with it the search would never end.
  constexpr double worst = 1e100;
  const Eigen::MatrixXd cost =
    given.unaryExpr([](double value) { return std::isfinite(value) ? value : worst; });
  const int rows = static_cast<int>(cost.rows());
  const int columns = static_cast<int>(cost.cols());
  std::vector<int> columnOfRow(rows, -1);
  if (rows > columns)
  {
    const std::vector<int> rowOfColumn = AssignRows(cost.transpose());
    for (int c = 0; c < columns; ++c)
    {
      columnOfRow[rowOfColumn[c]] = c;
    }
    return columnOfRow;
  }
  // Shortest augmenting paths with potentials; index 0 is a dummy.
  std::vector<double> rowPotential(rows + 1, 0.0);
  std::vector<double> columnPotential(columns + 1, 0.0);
  std::vector<int> rowOfColumn(columns + 1, 0);
  std::vector<int> previous(columns + 1, 0);
  for (int row = 1; row <= rows; ++row)
  {
    std::vector<double> slack(columns + 1, std::numeric_limits<double>::infinity());
    std::vector<bool> done(columns + 1, false);
    rowOfColumn[0] = row;
    int column = 0;
    do
    {
      done[column] = true;
      const int current = rowOfColumn[column];
      double least = std::numeric_limits<double>::infinity();
      int next = 0;
      for (int c = 1; c <= columns; ++c)
      {
        if (done[c])
        {
          continue;
        }
        const double reduced =
          cost(current - 1, c - 1) - rowPotential[current] - columnPotential[c];
        if (reduced < slack[c])
        {
          slack[c] = reduced;
          previous[c] = column;
        }
        if (slack[c] < least)
        {
          least = slack[c];
          next = c;
        }
      }
      for (int c = 0; c <= columns; ++c)
      {
        if (done[c])
        {
          rowPotential[rowOfColumn[c]] += least;
          columnPotential[c] -= least;
        }
        else
        {
          slack[c] -= least;
        }
      }
      column = next;
    } while (rowOfColumn[column] != 0);
    while (column != 0)
    {
      rowOfColumn[column] = rowOfColumn[previous[column]];
      column = previous[column];
    }
  }
  for (int c = 1; c <= columns; ++c)
  {
    if (rowOfColumn[c] > 0)
    {
      columnOfRow[rowOfColumn[c] - 1] = c - 1;
    }
  }
  return columnOfRow;
}
}
