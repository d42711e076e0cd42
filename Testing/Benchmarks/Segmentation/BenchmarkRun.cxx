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
  this->CheckMethod();
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

void BenchmarkRun::CheckMethod() const
{
  // Results of two methods must not end in one table.
  const std::string path = this->Options.ResultFolder + "/method.txt";
  const std::string method = this->Options.Method.Name();
  std::ifstream file(path);
  std::string earlier;
  if (std::getline(file, earlier) && earlier != method)
  {
    throw std::runtime_error(this->Options.ResultFolder +
      ": the results there are of another method (" + earlier + "); name another folder.");
  }
  if (this->Processes.IsFirst())
  {
    std::ofstream(path) << method << "\n";
  }
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
  if (this->Options.Method.Until == LastStage::Skeleton)
  {
    return pairs;
  }
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
    [&](int i)
    {
      prepared.Meshes[own[i]] = ComputeSkeleton(
        this->Options.DataFolder, category.Meshes[own[i]], this->Options.Method.Skeleton);
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

std::vector<int> BenchmarkRun::MissingMeshes(const Category& category) const
{
  std::vector<int> meshes;
  for (int i = 0; i < static_cast<int>(category.Meshes.size()); ++i)
  {
    if (!this->MeshTable.Has({ category.Name, category.Meshes[i], category.Meshes[i] }))
    {
      meshes.push_back(i);
    }
  }
  return meshes;
}

void BenchmarkRun::MeasureMeshes(const Category& category, const PreparedCategory& prepared,
  const std::vector<int>& meshes, ProgressBar& bar)
{
  const auto extremities = this->Figures.ExtremitiesOf.find(category.Name);
  RunJobs(static_cast<int>(meshes.size()), this->Options.Jobs,
    [&](int i)
    {
      Result result = MeasureSkeleton(prepared.Meshes[meshes[i]], category.Labels,
        extremities == this->Figures.ExtremitiesOf.end() ? Extremities() : extremities->second);
      result.Category = category.Name;
      const std::lock_guard<std::mutex> guard(this->Lock);
      this->MeshTable.Add(result);
      bar.Advance(category.Name + " " + std::to_string(result.Source));
    });
}

void BenchmarkRun::MeasurePairs(const Category& category, const PreparedCategory& prepared,
  const std::vector<std::pair<int, int>>& pairs, ProgressBar& bar)
{
  RunJobs(static_cast<int>(pairs.size()), this->Options.Jobs,
    [&](int i)
    {
      std::vector<int> segments;
      Result result = MeasurePair(prepared, pairs[i].first, pairs[i].second,
        this->Options.Method.Matcher, this->Options.Method.Until == LastStage::Transfer, segments);
      result.Category = category.Name;
      if (!segments.empty())
      {
        WriteSegments(SegmentFile(this->Options.ResultFolder, result), segments);
      }
      const std::lock_guard<std::mutex> guard(this->Lock);
      this->PairTable.Add(result);
      bar.Advance(category.Name + " " + std::to_string(result.Source) + " to " +
        std::to_string(result.Target));
    });
}

void BenchmarkRun::Measure()
{
  /// What is missing of a category, and this rank's share of it.
  struct Work
  {
    bool Any = false;
    std::vector<int> Meshes;
    std::vector<std::pair<int, int>> Pairs;
  };
  // Settled before anything is measured, so that the ranks agree.
  std::vector<Work> plan;
  int total = 0;
  for (const Category& category : this->Categories)
  {
    const std::vector<int> meshes = this->MissingMeshes(category);
    const std::vector<std::pair<int, int>> pairs = this->MissingPairs(category);
    plan.push_back(
      { !meshes.empty() || !pairs.empty(), this->OwnShare(meshes), this->OwnShare(pairs) });
    total += static_cast<int>(plan.back().Meshes.size() + plan.back().Pairs.size());
  }
  ProgressBar bar(total, this->Processes.IsFirst() && !this->Options.Quiet);
  for (std::size_t i = 0; i < this->Categories.size(); ++i)
  {
    if (plan[i].Any)
    {
      const PreparedCategory prepared = this->Prepare(this->Categories[i]);
      this->MeasureMeshes(this->Categories[i], prepared, plan[i].Meshes, bar);
      this->MeasurePairs(this->Categories[i], prepared, plan[i].Pairs, bar);
    }
  }
  this->JoinTables();
}

template <typename Item>
std::vector<Item> BenchmarkRun::OwnShare(const std::vector<Item>& items) const
{
  std::vector<Item> own;
  for (std::size_t i = this->Processes.Rank(); i < items.size(); i += this->Processes.Size())
  {
    own.push_back(items[i]);
  }
  return own;
}
}
