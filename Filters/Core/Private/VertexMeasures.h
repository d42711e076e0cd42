// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_VertexMeasures_h
#define marrow_VertexMeasures_h

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// The measures of vtkMSPField, one value per vertex.
struct VertexMeasures
{
  std::vector<double> AGD; ///< [0,1] per connected component
  std::vector<double> MSP; ///< mesh units
  std::vector<Eigen::Vector3d> MSPCenter;
  std::vector<Eigen::Vector3d> MSPNormal;   ///< unit; its sign means nothing
  std::vector<Eigen::Vector3d> MSPGradient; ///< dimensionless
  std::vector<unsigned char> MSPValid;      ///< 1 where the slice is closed by itself
  std::vector<double> DihedralAngle;        ///< radians
};
}

#endif
