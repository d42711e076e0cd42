// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_AnswerChoice_h
#define marrow_AnswerChoice_h

#include "AnalyzedMesh.h"
#include "Answer.h"
#include "CoarseMesh.h"
#include "DenseMap.h"
#include "Guidance.h"
#include "Progress.h"

#include <vector>

namespace marrow
{
/// What speaks against an answer.
struct Evidence
{
  double Cost = 1.0;      ///< the answer's
  double Thickness = 0.0; ///< mean |log of MSP here over MSP there|, sizes aside, at most 1 each
  double Cover = 0.0;     ///< how unevenly the other surface is hit, [0,1]
  double Turned = 0.0;    ///< mean of 1 - cosine of the normals, [0,2]

  double Hints = 0.0; ///< what the user's hints are not kept to; before all else

  /// What the surfaces say.
  double OfSurfaces() const { return this->Thickness + this->Cover + this->Turned; }
  double Sum() const { return this->Cost + this->OfSurfaces() + this->Hints; }
};

/// An answer carried out coarsely.
struct AnswerTrial
{
  Evidence Against;
  std::vector<int> FoundTriangles; ///< per vertex of the coarse target, of the coarse source
};

/// `mapper` is that of the two coarse meshes, and the hints speak of their vertices.
AnswerTrial TryAnswer(const CoarseMesh& source, const CoarseMesh& target, DenseMapper& mapper,
  const Answer& answer, const std::vector<SurfaceHint>& hints = {});

/// By the mean of Evidence's sum there and back, per answer (at least one): the indices, the likeliest
/// first. That is the one of the least sum; of equals the first, and the very first if no other is better
/// by more than noise.
std::vector<std::size_t> RankAnswers(const std::vector<double>& against);

/// The answers in the order of their likelihood.
struct AnswerRanking
{
  std::vector<std::size_t> Order; ///< indices, the likeliest first
  std::vector<double> Surfaces; ///< per answer the mean of what they say against it, there and back
};

/// How likely it is that an answer brings the right label to four fifths of the surface or more, [0,1], by
/// what the surfaces say against it.
double ConfidenceOf(double surfaces);

/// Carries every answer out coarsely, by dense maps between some 1000 points from target to source
/// and back, and ranks them by what is to be said against them: head and tail, or two fingers, may be
/// similar in length but not in thickness, and a wrong answer maps much of a surface to one place and
/// leaves others empty. The four pieces of evidence are of one order, and count alike; hints come before
/// all of them. The order is as it was if `progress` asked to stop.
AnswerRanking RankAnswers(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<Answer>& answers, const std::vector<SurfaceHint>& hints,
  const Progress& progress);
}

#endif
