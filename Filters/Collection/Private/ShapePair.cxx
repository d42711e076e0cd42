// SPDX-License-Identifier: BSD-3-Clause
#include "ShapePair.h"

#include "AnswerSearch.h"
#include "DenseMap.h"
#include "OtherAnswers.h"

#include <algorithm>
#include <istream>
#include <ostream>
#include <string>
#include <utility>

namespace marrow
{
namespace
{
/// What a file of a pair begins with; the number changes with all that the results depend on.
constexpr const char* Signature = "Marrow pair 4\n";

template <typename Value>
void WriteValue(std::ostream& stream, const Value& value)
{
  stream.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <typename Value>
bool ReadValue(std::istream& stream, Value& value)
{
  return static_cast<bool>(stream.read(reinterpret_cast<char*>(&value), sizeof(value)));
}

template <typename Value>
void WriteVector(std::ostream& stream, const std::vector<Value>& values)
{
  stream.write(reinterpret_cast<const char*>(values.data()),
    static_cast<std::streamsize>(values.size() * sizeof(Value)));
}

/// The size is known from the shapes, so that no file can ask for more memory than these have.
template <typename Value>
bool ReadVector(std::istream& stream, std::size_t size, std::vector<Value>& values)
{
  values.resize(size);
  return static_cast<bool>(stream.read(reinterpret_cast<char*>(values.data()),
    static_cast<std::streamsize>(values.size() * sizeof(Value))));
}

bool AreWithin(const std::vector<std::int32_t>& values, int size)
{
  return std::all_of(values.begin(), values.end(),
    [size](std::int32_t value) { return value >= 0 && value < size; });
}
}

bool ShapePair::MatchAgain(const Progress& progress)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (this->Answers.empty())
  {
    this->Answers = marrow::FindAnswers(
      this->Shapes[0]->Fine.Skeleton, this->Shapes[1]->Fine.Skeleton, {}, progress);
    if (!this->Answers.empty())
    {
      PreferSlices(this->Shapes[0]->Fine, this->Shapes[1]->Fine, this->Answers);
      AddWhole(this->Shapes[0]->Fine, this->Shapes[1]->Fine, this->Answers);
    }
  }
  return !this->Answers.empty();
}

bool ShapePair::FindAnswers(const Progress& progress)
{
  constexpr double afterMatching = 0.4; // of the progress
  if (!this->MatchAgain(SubProgress(progress, 0.0, afterMatching)))
  {
    return false;
  }
  std::vector<TriedAnswer> tried(this->Answers.size());
  for (int side = 0; side < 2; ++side)
  {
    const CollectionShape& source = *this->Shapes[1 - side];
    const CollectionShape& target = *this->Shapes[side];
    DenseMapper mapper(
      source.Coarse.Side, target.Coarse.Side, source.GetCoarseSearch(), target.GetCoarseSmoother());
    for (std::size_t a = 0; a < tried.size(); ++a)
    {
      const double done = (side + static_cast<double>(a) / tried.size()) / 2.0;
      if (!Report(progress, afterMatching + (1.0 - afterMatching) * done))
      {
        return false;
      }
      const Answer& answer = this->Answers[a];
      AnswerTrial trial =
        TryAnswer(source.Coarse, target.Coarse, mapper, side == 1 ? answer : Turned(answer));
      tried[a].Cost = trial.Against.Cost;
      tried[a].Confidence = answer.Confidence;
      tried[a].Against += 0.5 * trial.Against.Sum();
      tried[a].FoundTriangles[side].assign(
        trial.FoundTriangles.begin(), trial.FoundTriangles.end());
      tried[a].IsWhole = answer.IsWhole();
    }
  }
  this->Tried = std::move(tried);
  return true;
}

std::size_t ShapePair::LikeliestAnswer() const
{
  std::vector<double> against;
  for (const TriedAnswer& tried : this->Tried)
  {
    against.push_back(tried.Against);
  }
  return RankAnswers(against).front();
}

bool ShapePair::IsCarried(int side, std::size_t answer) const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Carried.count({ side, answer }) > 0;
}

bool ShapePair::Carry(int side, std::size_t answer, std::shared_ptr<const MeshSmoother> smoother,
  const Progress& progress)
{
  if (this->IsCarried(side, answer))
  {
    return true;
  }
  constexpr double afterMatching = 0.2; // of the progress
  if (!this->MatchAgain(SubProgress(progress, 0.0, afterMatching)))
  {
    return false;
  }
  const AnalyzedMesh& source = this->Shapes[1 - side]->Fine;
  const AnalyzedMesh& target = this->Shapes[side]->Fine;
  const Answer seen = side == 1 ? this->Answers[answer] : Turned(this->Answers[answer]);
  DenseMapper mapper(source, target, this->Shapes[1 - side]->GetFineSearch(), std::move(smoother));
  bool isStopped = false;
  const Progress watched = [&](double fraction)
  {
    isStopped = isStopped || !Report(progress, afterMatching + (1.0 - afterMatching) * fraction);
    return !isStopped;
  };
  const DenseMap map = mapper.Map(seen, watched);
  if (!isStopped)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Carried[{ side, answer }] = {
      { map.FoundTriangles.begin(), map.FoundTriangles.end() },
      { map.Certainty.begin(), map.Certainty.end() },
    };
  }
  return !isStopped;
}

void ShapePair::Write(std::ostream& stream) const
{
  stream << Signature;
  WriteValue(stream, static_cast<std::uint32_t>(this->Tried.size()));
  for (const TriedAnswer& tried : this->Tried)
  {
    WriteValue(stream, tried.Cost);
    WriteValue(stream, tried.Confidence);
    WriteValue(stream, tried.Against);
    WriteValue(stream, static_cast<std::uint8_t>(tried.IsWhole));
    WriteVector(stream, tried.FoundTriangles[0]);
    WriteVector(stream, tried.FoundTriangles[1]);
  }
  WriteValue(stream, static_cast<std::uint32_t>(this->Carried.size()));
  for (const auto& [key, map] : this->Carried)
  {
    WriteValue(stream, static_cast<std::uint32_t>(key.first));
    WriteValue(stream, static_cast<std::uint32_t>(key.second));
    WriteVector(stream, map.FoundTriangles);
    WriteVector(stream, map.Certainty);
  }
  stream << Signature;
}

bool ShapePair::Read(std::istream& stream)
{
  ShapePair read(this->Shapes[0], this->Shapes[1]);
  if (!read.ReadAll(stream))
  {
    return false;
  }
  this->Tried = std::move(read.Tried);
  this->Carried.merge(read.Carried);
  return true;
}

bool ShapePair::ReadAll(std::istream& stream)
{
  const auto readSignature = [&stream]()
  {
    std::vector<char> signature;
    const std::string expected = Signature;
    return ReadVector(stream, expected.size(), signature) &&
      std::equal(signature.begin(), signature.end(), expected.begin());
  };
  std::uint32_t size = 0;
  if (!readSignature() || !ReadValue(stream, size) || size < 1 || size > MostAnswers + 1)
  {
    return false;
  }
  this->Tried.resize(size);
  for (TriedAnswer& tried : this->Tried)
  {
    std::uint8_t isWhole = 0;
    if (!ReadValue(stream, tried.Cost) || !ReadValue(stream, tried.Confidence) ||
      !ReadValue(stream, tried.Against) || !ReadValue(stream, isWhole))
    {
      return false;
    }
    tried.IsWhole = isWhole != 0;
    for (int side = 0; side < 2; ++side)
    {
      if (!ReadVector(
            stream, this->Shapes[side]->Coarse.Side.Mesh.Points.size(), tried.FoundTriangles[side]))
      {
        return false;
      }
    }
  }
  std::uint32_t carried = 0;
  if (!ReadValue(stream, carried) || carried > 2 * size)
  {
    return false;
  }
  for (std::uint32_t i = 0; i < carried; ++i)
  {
    std::uint32_t side = 0;
    std::uint32_t answer = 0;
    if (!ReadValue(stream, side) || !ReadValue(stream, answer) || side > 1 || answer >= size)
    {
      return false;
    }
    CarriedMap& map = this->Carried[{ static_cast<int>(side), answer }];
    const std::size_t vertices = this->Shapes[side]->Fine.Mesh.Points.size();
    if (!ReadVector(stream, vertices, map.FoundTriangles) ||
      !ReadVector(stream, vertices, map.Certainty))
    {
      return false;
    }
  }
  return readSignature() && this->IsSound();
}

bool ShapePair::IsSound() const
{
  for (const TriedAnswer& tried : this->Tried)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (!AreWithin(tried.FoundTriangles[side],
            this->Shapes[1 - side]->Coarse.Side.Mesh.NumberOfTriangles()))
      {
        return false;
      }
    }
  }
  return std::all_of(this->Carried.begin(), this->Carried.end(),
    [this](const auto& entry)
    {
      return AreWithin(entry.second.FoundTriangles,
        this->Shapes[1 - entry.first.first]->Fine.Mesh.NumberOfTriangles());
    });
}
}
