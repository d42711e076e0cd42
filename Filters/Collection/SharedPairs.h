// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SharedPairs_h
#define marrow_SharedPairs_h

#include "PairBatch.h"
#include "Progress.h"

#include <string>
#include <utility>
#include <vector>

class vtkMultiProcessController;

namespace marrow
{
/// What takes long in a collection, spread over the processes of a controller: all have the same meshes, and
/// each finds out about its share of the pairs. They tell each other by the files of CollectedPairs, so that the
/// folder has to be the same for all; what a process does not find there it has to do itself. A process
/// holds a few dozen meshes and pairs at a time, however many there are.
///
/// All processes must call the same functions in the same order.
class SharedPairs
{
public:
  /// `learns`: labelled meshes are held out too (MeshesToHoldOut), and matched as what is to be labelled.
  SharedPairs(vtkMultiProcessController* controller, std::vector<CollectionMember> members,
    std::string folder, bool learns);
  /// Lets the other processes go on if the first never came to CarryMaps.
  ~SharedPairs();
  SharedPairs(const SharedPairs&) = delete;
  SharedPairs& operator=(const SharedPairs&) = delete;

  /// Whether there is more than one process.
  bool IsShared() const { return this->Size > 1; }
  bool IsFirst() const { return this->Rank == 0; }

  /// Matches all pairs that are worth it. False if any process was asked to stop.
  bool MatchPairs(const Progress& progress);
  /// Carries out the maps that the first process wants; what the others ask for does not count. Likewise.
  bool CarryMaps(std::vector<WantedMaps> wanted, const Progress& progress);

private:
  /// Each process's share of so many tasks.
  std::pair<std::size_t, std::size_t> ShareOf(std::size_t size) const;
  /// Waits for all; whether none was stopped.
  bool IsDoneByAll(bool isDone) const;

  vtkMultiProcessController* Controller;
  std::vector<CollectionMember> Members;
  std::string Folder;
  bool Learns;
  int Rank = 0;
  int Size = 1;
  bool IsAwaited = false; ///< by others, in CarryMaps
};
}

#endif
