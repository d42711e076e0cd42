// SPDX-License-Identifier: BSD-3-Clause
#include "Method.h"

namespace marrow::bench
{
std::string Method::SkeletonName() const
{
  return this->Skeleton == SkeletonKind::MSP ? "msp" : "curvature";
}

std::string Method::MatcherName() const
{
  return this->Matcher == MatcherKind::Tree ? "tree" : "electors";
}

std::string Method::Name() const
{
  static const char* const stages[] = { "skeleton", "correspondence", "transfer" };
  return "skeleton " + this->SkeletonName() + ", matcher " + this->MatcherName() + ", until " +
    stages[static_cast<int>(this->Until)];
}
}
