// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MatchingWeights_h
#define marrow_MatchingWeights_h

namespace marrow
{
/// The weights of what a matching costs: GlobalCost, and what its branches leave uncovered. One set for all
/// kinds of shapes.
struct MatchingWeights
{
  double Length = 0.9; ///< of how unlike two paths between terminals are: length
  double LengthTolerance =
    0.05;               ///< below it lengths hardly differ: they must not outweigh left and right
  double Profile = 1.0; ///< thickness along the paths
  double Chord = 0.35;  ///< straightness of their middle parts
  double Angle = 0.2;   ///< between the branches at their ends
  double Twin = 0.6;    ///< whether their ends are alike
  double Centricity = 0.2; ///< of how unlike two terminals are: AGD
  double Taper = 1.0;      ///< thickness from the tip inwards
  double Saturation = 0.6; ///< a pair this unlike costs half as much as it is unlike
  double Unmatched = 0.6;  ///< of terminals without partner
  double Split = 0.6;      ///< of branches that split the terminals as no branch of the other does
  double Pose = 0.15;      ///< of lying differently in space
  double Handedness = 0.025; ///< left from right, where all else is equal
  double Surface = 0.3;      ///< of a different share in the surface
  double Coverage = 0.1;     ///< of length that is not matched
};
}

#endif
