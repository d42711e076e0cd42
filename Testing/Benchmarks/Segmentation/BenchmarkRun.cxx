// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRun.h"

#include "ParallelJobs.h"
#include "ProgressBar.h"
#include "Ranks.h"
#include "SkeletonMeasures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
std::vector<Category> ChooseCategories(const BenchmarkOptions& options)
{
  std::vector<Category> categories = ReadIndex(options.DataFolder);
  for (const std::string& name : options.Categories)
  {
    if (std::none_of(categories.begin(), categories.end(),
          [&](const Category& category) { return category.Name == name; }))
    {
      throw std::runtime_error(name + ": there is no such category in " + options.DataFolder + ".");
    }
  }
  const auto isUnwanted = [&](const Category& category)
  {
    return !options.Categories.empty() &&
      std::count(options.Categories.begin(), options.Categories.end(), category.Name) == 0;
  };
  categories.erase(
    std::remove_if(categories.begin(), categories.end(), isUnwanted), categories.end());
  for (Category& category : categories)
  {
    if (options.MeshesPerCategory > 0 &&
      static_cast<int>(category.Meshes.size()) > options.MeshesPerCategory)
    {
      category.Meshes.resize(options.MeshesPerCategory);
    }
  }
  return categories;
}

void WriteSegments(const std::string& path, const std::vector<int>& segments)
{
  std::ofstream file(path);
  for (const int segment : segments)
  {
    file << segment << "\n";
  }
}
}

BenchmarkRun::BenchmarkRun(
  const BenchmarkOptions& options, const ReferenceFigures& figures, Ranks& processes)
  : Options(options)
  , Figures(figures)
  , Processes(processes)
  , Categories(ChooseCategories(options))
  , PairTable(PairColumns())
  , MeshTable(MeshColumns())
{
  for (const Category& category : this->Categories)
  {
    std::filesystem::create_directories(options.ResultFolder + "/segments/" + category.Name);
  }
  this->ReadTables();
}

std::string BenchmarkRun::SegmentFile(const std::string& resultFolder, const Result& pair)
{
  return resultFolder + "/segments/" + pair.Category + "/" + std::to_string(pair.Source) + "_" +
    std::to_string(pair.Target) + ".seg";
}

std::string BenchmarkRun::TableFile(const std::string& name, int rank) const
{
  const std::string part = rank == 0 ? "" : "-" + std::to_string(rank);
  return this->Options.ResultFolder + "/" + name + part + ".csv";
}

void BenchmarkRun::ReadTables()
{
  // Also those of an earlier run with more ranks that was stopped.
  for (int rank = 0;
       rank < this->Processes.Size() || std::filesystem::exists(this->TableFile("pairs", rank));
       ++rank)
  {
    this->PairTable.Read(this->TableFile("pairs", rank));
    this->MeshTable.Read(this->TableFile("meshes", rank));
  }
  // Nobody may write before all have read.
  this->Processes.Barrier();
  this->PairTable.AppendTo(this->TableFile("pairs", this->Processes.Rank()));
  this->MeshTable.AppendTo(this->TableFile("meshes", this->Processes.Rank()));
}

void BenchmarkRun::JoinTables()
{
  this->Processes.Barrier();
  if (!this->Processes.IsFirst())
  {
    return;
  }
  for (int rank = 1; std::filesystem::exists(this->TableFile("pairs", rank)); ++rank)
  {
    this->PairTable.Read(this->TableFile("pairs", rank));
    this->MeshTable.Read(this->TableFile("meshes", rank));
  }
  this->PairTable.Write(this->TableFile("pairs", 0));
  this->MeshTable.Write(this->TableFile("meshes", 0));
  for (int rank = 1; std::filesystem::remove(this->TableFile("pairs", rank)); ++rank)
  {
    std::filesystem::remove(this->TableFile("meshes", rank));
  }
}

std::vector<std::pair<int, int>> BenchmarkRun::MissingPairs(const Category& category) const
{
  std::vector<std::pair<int, int>> pairs;
  for (int source = 0; source < static_cast<int>(category.Meshes.size()); ++source)
  {
    for (int target = 0; target < static_cast<int>(category.Meshes.size()); ++target)
    {
      if (source != target &&
        !this->PairTable.Has({ category.Name, category.Meshes[source], category.Meshes[target] }))
      {
        pairs.emplace_back(source, target);
      }
    }
  }
  return pairs;
}

PreparedCategory BenchmarkRun::Prepare(const Category& category)
{
  PreparedCategory prepared;
  const int size = static_cast<int>(category.Meshes.size());
  prepared.Meshes.resize(size);
  prepared.Features.resize(size);
  std::vector<int> own;
  for (int i = this->Processes.Rank(); i < size; i += this->Processes.Size())
  {
    own.push_back(i);
  }
  RunJobs(static_cast<int>(own.size()), this->Options.Jobs,
    [&](int i) {
      prepared.Meshes[own[i]] = ComputeSkeleton(this->Options.DataFolder, category.Meshes[own[i]]);
    });
  for (int i = 0; i < size; ++i)
  {
    PreparedMesh& mesh = prepared.Meshes[i];
    const int root = i % this->Processes.Size();
    mesh.Id = category.Meshes[i];
    double seconds[] = { mesh.SecondsForField, mesh.SecondsForSkeleton };
    this->Processes.Broadcast(mesh.Surface, root);
    this->Processes.Broadcast(mesh.Skeleton, root);
    this->Processes.Broadcast(mesh.Error, root);
    this->Processes.Broadcast(seconds, 2, root);
    mesh.SecondsForField = seconds[0];
    mesh.SecondsForSkeleton = seconds[1];
  }
  RunJobs(size, this->Options.Jobs,
    [&](int i)
    {
      ReadGroundTruth(this->Options.DataFolder, prepared.Meshes[i]);
      prepared.Features[i] = FindTerminalFeatures(prepared.Meshes[i]);
    });
  prepared.MirrorFeatures = FindMirrorFeatures(prepared.Features);
  return prepared;
}

void BenchmarkRun::MeasureMeshes(const Category& category, const PreparedCategory& prepared)
{
  const auto extremities = this->Figures.ExtremitiesOf.find(category.Name);
  std::vector<int> missing;
  for (int i = this->Processes.Rank(); i < static_cast<int>(category.Meshes.size());
       i += this->Processes.Size())
  {
    if (!this->MeshTable.Has({ category.Name, category.Meshes[i], category.Meshes[i] }))
    {
      missing.push_back(i);
    }
  }
  RunJobs(static_cast<int>(missing.size()), this->Options.Jobs,
    [&](int i)
    {
      Result result = MeasureSkeleton(prepared.Meshes[missing[i]], category.Labels,
        extremities == this->Figures.ExtremitiesOf.end() ? Extremities() : extremities->second);
      result.Category = category.Name;
      const std::lock_guard<std::mutex> guard(this->Lock);
      this->MeshTable.Add(result);
    });
}

void BenchmarkRun::MeasurePairs(const Category& category, const PreparedCategory& prepared,
  const std::vector<std::pair<int, int>>& pairs, ProgressBar& bar)
{
  RunJobs(static_cast<int>(pairs.size()), this->Options.Jobs,
    [&](int i)
    {
      std::vector<int> segments;
      Result result = MeasurePair(prepared, pairs[i].first, pairs[i].second, segments);
      result.Category = category.Name;
      WriteSegments(SegmentFile(this->Options.ResultFolder, result), segments);
      const std::lock_guard<std::mutex> guard(this->Lock);
      this->PairTable.Add(result);
      bar.Advance(category.Name + " " + std::to_string(result.Source) + " to " +
        std::to_string(result.Target));
    });
}

void BenchmarkRun::Measure()
{
  const int rank = this->Processes.Rank();
  const int ranks = this->Processes.Size();
  // What is missing is settled before anything is measured, so that the ranks agree.
  std::vector<std::vector<std::pair<int, int>>> all, own;
  int total = 0;
  for (const Category& category : this->Categories)
  {
    all.push_back(this->MissingPairs(category));
    own.emplace_back();
    for (std::size_t i = rank; i < all.back().size(); i += ranks)
    {
      own.back().push_back(all.back()[i]);
    }
    total += static_cast<int>(own.back().size());
  }
  ProgressBar bar(total, this->Processes.IsFirst() && !this->Options.Quiet);
  for (std::size_t i = 0; i < this->Categories.size(); ++i)
  {
    if (!all[i].empty())
    {
      const PreparedCategory prepared = this->Prepare(this->Categories[i]);
      this->MeasureMeshes(this->Categories[i], prepared);
      this->MeasurePairs(this->Categories[i], prepared, own[i], bar);
    }
  }
  this->JoinTables();
}
}
