// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnswerChoice_h
#define marrow_AnswerChoice_h

#include "AnalyzedMesh.h"
#include "CoarseMesh.h"
#include "DenseMap.h"
#include "MatchedSkeletons.h"
#include "Progress.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// One of the answers to what corresponds to what.
struct Answer
{
  MatchedSkeletons Match;
  double Cost = 1.0;       ///< by the skeletons alone, some 0 to 1
  double Confidence = 1.0; ///< [0,1]
};

/// More are not tried: the right one is hardly ever farther down, and each takes time.
inline constexpr std::size_t MostAnswers = 10;

/// What speaks against an answer.
struct Evidence
{
  double Cost = 1.0; ///< by the skeletons; 1 where nothing is matched
  /// Mean |log of MSP here over MSP there|, at most 1 each, the median ratio aside.
  double Thickness = 0.0;
  double Cover = 0.0; ///< how unevenly the source is hit, [0,1]

  double Sum() const { return this->Cost + this->Thickness + this->Cover; }
};

/// An answer carried out coarsely.
struct AnswerTrial
{
  Evidence Against;
  std::vector<int> FoundTriangles; ///< per vertex of the coarse target, of the coarse source
  bool IsWholeAlignment = false;   ///< the skeletons were of no use
};

/// `mapper` is that of the two coarse meshes.
AnswerTrial TryAnswer(const CoarseMesh& source, const CoarseMesh& target, const DenseMapper& mapper,
  const Answer& answer);

/// Carries every answer out coarsely, by a dense map between some 1000 points, and takes that against
/// which least is to be said: head and tail, or two fingers, may be alike in length but not in
/// thickness, and a wrong answer maps much of the target to one place and leaves others empty. The
/// three are of one order, and count alike. Returns the index; that of the first, if no other is
/// better by more than noise. `whole` is
/// AlignWhole's.
std::size_t ChooseAnswer(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<Answer>& answers, const Eigen::Matrix<double, 3, 4>& whole,
  const Progress& progress);
}

#endif
