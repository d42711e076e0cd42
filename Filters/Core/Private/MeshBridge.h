// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshBridge_h
#define marrow_MeshBridge_h

#include "TriangleMesh.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkPolyData;

namespace marrow
{
/// Copies a vtkPolyData into a TriangleMesh with its connectivity; vertex i is point i, triangle t
/// is cell t. Returns one sentence that says what is wrong, or an empty one: the input must have
/// triangles and nothing but triangles, all of them with finite points.
std::string ToTriangleMesh(vtkPolyData* input, TriangleMesh& mesh);

// Plain vectors to named VTK arrays. An array of the same name is replaced.
void SetArray(vtkDataSetAttributes* data, const char* name, const std::vector<double>& values);
void SetArray(
  vtkDataSetAttributes* data, const char* name, const std::vector<Eigen::Vector3d>& values);
void SetArray(
  vtkDataSetAttributes* data, const char* name, const std::vector<unsigned char>& values);

/// Up to so many different values viewers take the integers below for labels, each with a colour of its
/// own; of themselves they stop at 32.
constexpr unsigned int MostLabels = 256;
void SetIntArray(vtkDataSetAttributes* data, const char* name, const std::vector<int>& values);
void SetIdArray(vtkDataSetAttributes* data, const char* name, const std::vector<int>& values);

/// Named VTK arrays to plain vectors; false if there is no such array, or not with that number of
/// components and `size` tuples.
bool GetArray(vtkDataSetAttributes* data, const char* name, int size, std::vector<double>& values);
bool GetArray(
  vtkDataSetAttributes* data, const char* name, int size, std::vector<Eigen::Vector3d>& values);
bool GetArray(
  vtkDataSetAttributes* data, const char* name, int size, std::vector<unsigned char>& values);
bool GetArray(vtkDataSetAttributes* data, const char* name, int size, std::vector<int>& values);
}

#endif
