// SPDX-License-Identifier: BSD-3-Clause
#include "SharedPairs.h"

#include "CollectedMeshes.h"
#include "PairBatch.h"
#include "PairSelection.h"

#include <vtkMultiProcessController.h>
#include <vtkMultiProcessStream.h>

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

namespace marrow
{
namespace
{
/// So many are held at a time: enough for all threads, and for meshes that several pairs of a batch share.
constexpr std::size_t BatchSize = 64;

/// What all processes know of every shape.
struct Summary
{
  std::string Key;
  int Member = 0;
  int Body = 0;
  std::vector<double> Sketch;
};

void Put(const Summary& summary, vtkMultiProcessStream& stream)
{
  stream << summary.Key << summary.Member << summary.Body
         << static_cast<int>(summary.Sketch.size());
  for (const double value : summary.Sketch)
  {
    stream << value;
  }
}

Summary Take(vtkMultiProcessStream& stream)
{
  Summary summary;
  int size = 0;
  stream >> summary.Key >> summary.Member >> summary.Body >> size;
  summary.Sketch.resize(static_cast<std::size_t>(size));
  for (double& value : summary.Sketch)
  {
    stream >> value;
  }
  return summary;
}

/// Of the members that are this process's.
bool Summarize(const std::vector<CollectionMember>& members, std::size_t first, std::size_t last,
  vtkMultiProcessStream& stream, const Progress& progress)
{
  for (std::size_t start = first; start < last; start += BatchSize)
  {
    const std::size_t end = std::min(start + BatchSize, last);
    std::vector<vtkPolyData*> meshes;
    for (std::size_t m = start; m < end; ++m)
    {
      meshes.push_back(members[m].Mesh);
    }
    std::vector<std::shared_ptr<const CollectedMesh>> collected;
    const double size = static_cast<double>(last - first);
    if (!CollectedMeshes().Collect(
          meshes, collected, SubProgress(progress, (start - first) / size, (end - first) / size)))
    {
      return false;
    }
    for (std::size_t m = start; m < end; ++m)
    {
      for (std::size_t b = 0; b < collected[m - start]->Shapes.size(); ++b)
      {
        const CollectionShape& shape = *collected[m - start]->Shapes[b];
        Put({ shape.Key, static_cast<int>(m), static_cast<int>(b), SketchOf(shape.Fine.Skeleton) },
          stream);
      }
    }
  }
  return true;
}

std::vector<std::pair<int, int>> SelectPairsOf(
  const std::vector<Summary>& summaries, const std::vector<CollectionMember>& members, bool learns)
{
  std::vector<SketchedShape> shapes;
  for (const Summary& summary : summaries)
  {
    shapes.push_back({ summary.Sketch, summary.Member, members[summary.Member].IsSource });
  }
  return ChoosePairs(shapes, learns).Pairs;
}
}

SharedPairs::SharedPairs(vtkMultiProcessController* controller,
  std::vector<CollectionMember> members, std::string folder, bool learns)
  : Controller(controller)
  , Members(std::move(members))
  , Folder(std::move(folder))
  , Learns(learns)
{
  if (controller)
  {
    this->Rank = controller->GetLocalProcessId();
    this->Size = controller->GetNumberOfProcesses();
  }
}

SharedPairs::~SharedPairs()
{
  if (this->IsAwaited)
  {
    this->CarryMaps({}, {});
  }
}

std::pair<std::size_t, std::size_t> SharedPairs::ShareOf(std::size_t size) const
{
  return { size * this->Rank / this->Size, size * (this->Rank + 1) / this->Size };
}

bool SharedPairs::IsDoneByAll(bool isDone) const
{
  const int own = isDone ? 1 : 0;
  int all = 0;
  this->Controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  return all == 1;
}

bool SharedPairs::MatchPairs(const Progress& progress)
{
  constexpr double afterSummaries = 0.1; // of the progress
  vtkMultiProcessStream own;
  const auto [firstMember, lastMember] = this->ShareOf(this->Members.size());
  bool isDone = Summarize(
    this->Members, firstMember, lastMember, own, SubProgress(progress, 0.0, afterSummaries));
  std::vector<vtkMultiProcessStream> all;
  this->Controller->AllGather(own, all);
  std::vector<Summary> summaries;
  for (vtkMultiProcessStream& stream : all)
  {
    while (!stream.Empty())
    {
      summaries.push_back(Take(stream));
    }
  }
  // In the order of vtkCollectionTransfer's shapes.
  std::sort(summaries.begin(), summaries.end(),
    [](const Summary& a, const Summary& b)
    { return std::tie(a.Key, a.Member, a.Body) < std::tie(b.Key, b.Member, b.Body); });
  isDone = this->IsDoneByAll(isDone);
  const std::vector<std::pair<int, int>> selected = isDone
    ? SelectPairsOf(summaries, this->Members, this->Learns)
    : std::vector<std::pair<int, int>>();
  const auto [first, last] = this->ShareOf(selected.size());
  PairBatch batch(this->Members, this->Folder);
  for (std::size_t start = first; isDone && start < last; start += BatchSize)
  {
    const std::size_t end = std::min(start + BatchSize, last);
    std::vector<PairEnds> pairs;
    for (std::size_t p = start; p < end; ++p)
    {
      const Summary& one = summaries[selected[p].first];
      const Summary& other = summaries[selected[p].second];
      pairs.push_back({ { { one.Member, one.Body }, { other.Member, other.Body } } });
    }
    const auto done = [&, begin = first, size = last - first](std::size_t at)
    { return afterSummaries + (1.0 - afterSummaries) * static_cast<double>(at - begin) / size; };
    isDone = batch.Collect(pairs, SubProgress(progress, done(start), done(end)));
  }
  this->IsAwaited = this->IsFirst();
  return this->IsDoneByAll(isDone);
}

bool SharedPairs::CarryMaps(std::vector<WantedMaps> wanted, const Progress& progress)
{
  this->IsAwaited = false;
  vtkMultiProcessStream stream;
  stream << static_cast<int>(wanted.size());
  for (const WantedMaps& of : wanted)
  {
    stream << of.Ends[0].first << of.Ends[0].second << of.Ends[1].first << of.Ends[1].second
           << static_cast<int>(of.OfAnswers.size());
    for (const auto& [side, answer] : of.OfAnswers)
    {
      stream << side << static_cast<int>(answer);
    }
  }
  this->Controller->Broadcast(stream, 0);
  int size = 0;
  stream >> size;
  wanted.assign(static_cast<std::size_t>(size), {});
  for (WantedMaps& of : wanted)
  {
    int answers = 0;
    stream >> of.Ends[0].first >> of.Ends[0].second >> of.Ends[1].first >> of.Ends[1].second >>
      answers;
    for (int i = 0; i < answers; ++i)
    {
      int side = 0;
      int answer = 0;
      stream >> side >> answer;
      of.OfAnswers.emplace_back(side, static_cast<std::size_t>(answer));
    }
  }
  const auto [first, last] = this->ShareOf(wanted.size());
  PairBatch batch(this->Members, this->Folder);
  bool isDone = true;
  for (std::size_t start = first; isDone && start < last; start += BatchSize)
  {
    const std::size_t end = std::min(start + BatchSize, last);
    const std::vector<WantedMaps> now(wanted.begin() + static_cast<std::ptrdiff_t>(start),
      wanted.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<PairEnds> pairs;
    for (const WantedMaps& of : now)
    {
      pairs.push_back(of.Ends);
    }
    isDone = batch.Collect(pairs, {}) &&
      Report(progress, static_cast<double>(end - first) / static_cast<double>(last - first));
    if (isDone)
    {
      batch.Carry(now);
    }
  }
  return this->IsDoneByAll(isDone);
}
}
