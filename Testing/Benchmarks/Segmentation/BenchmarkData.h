// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BenchmarkData_h
#define marrow_BenchmarkData_h

#include <string>
#include <vector>

/// The folder with the benchmark's files:
///
///   index.json       per category: ids (mesh ids) and labels (names of the semantic labels)
///   meshes/ID.off    the meshes
///   labels/ID.seg    per face the semantic label, an index into the names
///   pieces/ID.seg    per face the connected piece of a label
///   humans/ID_k.seg  human segmentations, k from 0 or 1 on
///   features/ID.vts  corresponding feature points, a row each: vertex id, position; may be missing
///
/// All functions throw std::runtime_error with one sentence that says what is wrong.
namespace marrow::bench
{
struct Category
{
  std::string Name;
  std::vector<int> Meshes;
  std::vector<std::string> Labels;
};

/// In the order of the file.
std::vector<Category> ReadIndex(const std::string& folder);

/// One integer per face.
std::vector<int> ReadSegmentFile(const std::string& path, std::size_t faces);

std::string MeshFile(const std::string& folder, int mesh);
std::vector<int> ReadLabels(const std::string& folder, int mesh, std::size_t faces);
std::vector<int> ReadPieces(const std::string& folder, int mesh, std::size_t faces);
std::vector<std::vector<int>> ReadHumans(const std::string& folder, int mesh, std::size_t faces);
/// Vertex ids; empty where there is no file.
std::vector<int> ReadFeatures(const std::string& folder, int mesh);
}

#endif
