// SPDX-License-Identifier: BSD-3-Clause
#include "CollectedPairs.h"

#include "ParallelFor.h"
#include "SharedProgress.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace marrow
{
namespace
{
using Keys = std::pair<std::string, std::string>;

Keys KeysOf(const CollectedPairs::Ends& ends)
{
  return { ends.first->Key, ends.second->Key };
}

std::filesystem::path FileOf(const std::string& folder, const Keys& keys)
{
  return std::filesystem::path(folder) / (keys.first + "-" + keys.second + ".pair");
}

bool ReadPair(const std::filesystem::path& path, ShapePair& pair)
{
  std::ifstream stream(path, std::ios::binary);
  return stream && pair.Read(stream);
}

/// Under another name first, so that a file is whole or not there.
bool WritePair(const std::filesystem::path& path, const ShapePair& pair)
{
  std::filesystem::path part = path;
  part += ".part";
  std::ofstream stream(part, std::ios::binary);
  pair.Write(stream);
  stream.close();
  std::error_code error;
  if (stream)
  {
    std::filesystem::rename(part, path, error);
  }
  else
  {
    std::filesystem::remove(part, error);
    return false;
  }
  return !error;
}
}

bool CollectedPairs::Collect(const std::vector<Ends>& ends, const std::string& folder,
  std::vector<ShapePair*>& pairs, const Progress& progress)
{
  std::map<Keys, Entry> kept;
  for (const Ends& of : ends)
  {
    const Keys keys = KeysOf(of);
    const auto known = this->Known.find(keys);
    if (known != this->Known.end())
    {
      kept[keys] = std::move(known->second);
      this->Known.erase(known);
    }
    else if (!kept.count(keys))
    {
      kept[keys].Pair = std::make_unique<ShapePair>(of.first, of.second);
    }
  }
  this->Known = std::move(kept);
  std::vector<std::pair<const Keys*, Entry*>> unknown;
  for (auto& [keys, entry] : this->Known)
  {
    if (!entry.Pair->IsKnown())
    {
      unknown.emplace_back(&keys, &entry);
    }
  }
  SharedProgress shared(progress);
  ParallelFor(0, static_cast<int>(unknown.size()),
    [&](int first, int last)
    {
      for (int i = first; i < last; ++i)
      {
        const auto& [keys, entry] = unknown[i];
        if (!folder.empty() && ReadPair(FileOf(folder, *keys), *entry->Pair))
        {
          entry->IsInFile = true;
          entry->NumberInFile = entry->Pair->NumberOfCarried();
          shared.Add(1.0 / unknown.size());
          continue;
        }
        double done = 0.0;
        const bool isDone = entry->Pair->FindAnswers(
          [&](double fraction)
          {
            const double step = fraction - done;
            done = fraction;
            return shared.Add(step / unknown.size());
          });
        if (!isDone || !shared.Add((1.0 - done) / unknown.size()))
        {
          return;
        }
        if (!folder.empty())
        {
          entry->IsInFile = WritePair(FileOf(folder, *keys), *entry->Pair);
        }
      }
    });
  pairs.clear();
  bool isComplete = true;
  for (const Ends& of : ends)
  {
    pairs.push_back(this->Known[KeysOf(of)].Pair.get());
    isComplete = isComplete && pairs.back()->IsKnown();
  }
  return isComplete;
}

void CollectedPairs::ReadAgain(const std::string& folder)
{
  for (auto& [keys, entry] : this->Known)
  {
    if (ReadPair(FileOf(folder, keys), *entry.Pair))
    {
      entry.IsInFile = true;
      entry.NumberInFile = entry.Pair->NumberOfCarried();
    }
  }
}

void CollectedPairs::Save(const std::string& folder)
{
  for (auto& [keys, entry] : this->Known)
  {
    const std::size_t carried = entry.Pair->NumberOfCarried();
    if (entry.Pair->IsKnown() && (!entry.IsInFile || carried > entry.NumberInFile))
    {
      entry.IsInFile = WritePair(FileOf(folder, keys), *entry.Pair);
      entry.NumberInFile = carried;
    }
  }
}
}
