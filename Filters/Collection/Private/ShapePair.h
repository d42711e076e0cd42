// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ShapePair_h
#define marrow_ShapePair_h

#include "AnswerChoice.h"
#include "CollectionShape.h"
#include "MeshSmoother.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace marrow
{
/// Where one shape lies on another by one answer, at the working resolution.
struct CarriedMap
{
  std::vector<std::int32_t> FoundTriangles; ///< per vertex of the one, of the other
  std::vector<float> Certainty;             ///< per vertex, as DenseMap's
};

/// An answer to how two shapes correspond, tried out coarsely both ways. The vectors of two: as seen by
/// the first and by the second shape.
struct TriedAnswer
{
  double Cost = 1.0; ///< the answer's
  double Confidence = 0.0;
  double Against = 0.0; ///< what speaks against it, by the mean of both ways: Evidence's sum
  std::array<std::vector<std::int32_t>, 2>
    FoundTriangles;     ///< per coarse vertex, of the other's coarse mesh
  bool IsWhole = false; ///< nothing is matched: aligned as wholes
};

/// Two shapes of a collection and the answers to how they correspond. Nothing of it depends on labels, so
/// it can be kept and written to a file.
class ShapePair
{
public:
  using Shape = std::shared_ptr<const CollectionShape>;

  ShapePair(Shape first, Shape second)
    : Shapes{ std::move(first), std::move(second) }
  {
  }

  /// Matches the two skeletons, once for both ways, and tries all answers. False if `progress` asked to
  /// stop; there are no answers then.
  bool FindAnswers(const Progress& progress);
  bool IsKnown() const { return !this->Tried.empty(); }

  /// The cheapest first, by the skeletons alone; the one that matches nothing is the last.
  const std::vector<TriedAnswer>& GetAnswers() const { return this->Tried; }
  /// The answer against which least speaks; the cheapest if no other is better by more than noise.
  std::size_t LikeliestAnswer() const;

  /// Carries out how an answer maps shape `side` (0 or 1) to the other, at the working resolution, unless
  /// that was done before. `smoother` is DenseMapper's of the shape `side`. False if `progress` asked to
  /// stop. Both sides may be carried at a time.
  bool Carry(int side, std::size_t answer, std::shared_ptr<const MeshSmoother> smoother,
    const Progress& progress);
  bool IsCarried(int side, std::size_t answer) const;
  std::size_t NumberOfCarried() const { return this->Carried.size(); }
  const CarriedMap& GetCarried(int side, std::size_t answer) const
  {
    return this->Carried.at({ side, answer });
  }

  /// In the order of bytes of this machine. What is read is added to what was carried out already. False if it
  /// is not of these two shapes; nothing is changed then.
  void Write(std::ostream& stream) const;
  bool Read(std::istream& stream);

private:
  bool ReadAll(std::istream& stream);
  bool MatchAgain(const Progress& progress);
  bool IsSound() const;

  std::array<Shape, 2> Shapes;
  std::vector<TriedAnswer> Tried;
  std::map<std::pair<int, std::size_t>, CarriedMap> Carried;
  std::vector<Answer> Answers; ///< the first shape is the source; not kept in a file
  mutable std::mutex Guard;    ///< of the last two
};
}

#endif
