// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkData.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
std::string FileOf(
  const std::string& folder, const std::string& kind, int mesh, const std::string& ending)
{
  return folder + "/" + kind + "/" + std::to_string(mesh) + ending;
}
}

std::vector<Category> ReadIndex(const std::string& folder)
{
  const std::string path = folder + "/index.json";
  std::ifstream file(path);
  if (!file)
  {
    throw std::runtime_error(path + ": there is no such file; name the benchmark's folder.");
  }
  std::vector<Category> categories;
  try
  {
    const nlohmann::ordered_json json = nlohmann::ordered_json::parse(file);
    for (const auto& [name, entry] : json.items())
    {
      categories.push_back({ name, entry.at("ids").get<std::vector<int>>(),
        entry.at("labels").get<std::vector<std::string>>() });
    }
  }
  catch (const nlohmann::json::exception& error)
  {
    throw std::runtime_error(path + ": " + error.what());
  }
  return categories;
}

std::vector<int> ReadSegmentFile(const std::string& path, std::size_t faces)
{
  std::ifstream file(path);
  std::vector<int> segments;
  for (int id = 0; file >> id;)
  {
    segments.push_back(id);
  }
  if (segments.size() != faces)
  {
    throw std::runtime_error(path + ": " + std::to_string(segments.size()) +
      " integers for a mesh of " + std::to_string(faces) + " faces.");
  }
  return segments;
}

std::string MeshFile(const std::string& folder, int mesh)
{
  return FileOf(folder, "meshes", mesh, ".off");
}

std::vector<int> ReadLabels(const std::string& folder, int mesh, std::size_t faces)
{
  return ReadSegmentFile(FileOf(folder, "labels", mesh, ".seg"), faces);
}

std::vector<int> ReadPieces(const std::string& folder, int mesh, std::size_t faces)
{
  return ReadSegmentFile(FileOf(folder, "pieces", mesh, ".seg"), faces);
}

std::vector<std::vector<int>> ReadHumans(const std::string& folder, int mesh, std::size_t faces)
{
  std::vector<std::vector<int>> humans;
  for (int k = 0;; ++k)
  {
    const std::string path = FileOf(folder, "humans", mesh, "_" + std::to_string(k) + ".seg");
    if (std::filesystem::exists(path))
    {
      humans.push_back(ReadSegmentFile(path, faces));
    }
    else if (k > 0)
    {
      break;
    }
  }
  if (humans.empty())
  {
    throw std::runtime_error(
      folder + "/humans: there is no segmentation of mesh " + std::to_string(mesh) + ".");
  }
  return humans;
}

std::vector<int> ReadFeatures(const std::string& folder, int mesh)
{
  std::ifstream file(FileOf(folder, "features", mesh, ".vts"));
  std::vector<int> features;
  for (int vertex = 0; file >> vertex;)
  {
    features.push_back(vertex);
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return features;
}
}
