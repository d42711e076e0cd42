// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnswerChoice_h
#define marrow_AnswerChoice_h

#include "AnalyzedMesh.h"
#include "CoarseMesh.h"
#include "DenseMap.h"
#include "MatchedSkeletons.h"
#include "Progress.h"

#include <vector>

namespace marrow
{
/// One of the answers to what corresponds to what.
struct Answer
{
  MatchedSkeletons Match;
  double Cost = 1.0;       ///< by the skeletons alone, some 0 to 1
  double Confidence = 1.0; ///< [0,1]

  /// 1 where nothing is matched, which costs the skeletons nothing.
  double CostOfMatch() const { return this->Match.IsEmpty() ? 1.0 : this->Cost; }
};

/// More are not tried: the right one is hardly ever farther down, and each takes time.
inline constexpr std::size_t MostAnswers = 10;

/// What speaks against an answer.
struct Evidence
{
  double Cost = 1.0;      ///< by the skeletons; 1 where nothing is matched
  double Thickness = 0.0; ///< mean |log of MSP here over MSP there|, sizes aside, at most 1 each
  double Cover = 0.0;     ///< how unevenly the other surface is hit, [0,1]
  double Turned = 0.0;    ///< mean of 1 - cosine of the normals, [0,2]

  double Sum() const { return this->Cost + this->Thickness + this->Cover + this->Turned; }
};

/// An answer carried out coarsely.
struct AnswerTrial
{
  Evidence Against;
  std::vector<int> FoundTriangles; ///< per vertex of the coarse target, of the coarse source
  bool IsWholeAlignment = false;   ///< the skeletons were of no use
};

/// `mapper` is that of the two coarse meshes.
AnswerTrial TryAnswer(
  const CoarseMesh& source, const CoarseMesh& target, DenseMapper& mapper, const Answer& answer);

/// By the mean of Evidence's sum there and back, per answer: the index of the least; of equals the
/// first, and the very first if no other is better by more than noise.
std::size_t LikeliestAnswer(const std::vector<double>& against);

/// Carries every answer out coarsely, by dense maps between some 1000 points from target to source
/// and back, and takes that against which least is to be said: head and tail, or two fingers, may be
/// similar in length but not in thickness, and a wrong answer maps much of a surface to one place and
/// leaves others empty. The four pieces of evidence are of one order, and count alike. Returns the
/// index; 0 if `progress` asked to stop.
std::size_t ChooseAnswer(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<Answer>& answers, const Progress& progress);
}

#endif
