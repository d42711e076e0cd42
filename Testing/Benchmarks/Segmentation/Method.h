// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Method_h
#define marrow_Method_h

#include <string>

namespace marrow::bench
{
enum class SkeletonKind
{
  MSP,          ///< vtkMSPSkeleton
  MeanCurvature ///< vtkMarrowMeanCurvatureSkeleton
};

/// Of vtkSkeletonCorrespondence.
enum class MatcherKind
{
  Tree,
  Electors
};

/// Where to stop.
enum class LastStage
{
  Skeleton,
  Correspondence,
  Transfer
};

/// What is measured. Results of two methods never end in one folder.
struct Method
{
  SkeletonKind Skeleton = SkeletonKind::MSP;
  MatcherKind Matcher = MatcherKind::Tree;
  LastStage Until = LastStage::Transfer;

  /// As the command line says it: msp or curvature; tree or electors.
  std::string SkeletonName() const;
  std::string MatcherName() const;
  /// All of it.
  std::string Name() const;
};
}

#endif
