// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MatchingWeights_h
#define marrow_MatchingWeights_h

namespace marrow
{
/// The weights of what a matching costs: GlobalCost, and what its branches leave uncovered. One set for all
/// kinds of shapes, chosen on labelled meshes of animals, humans, bears, hands, birds and planes; fit_weights.py
/// of the segmentation benchmark tries others.
struct MatchingWeights
{
  // Two paths between terminals differ by:
  double Length = 0.9;           ///< their length,
  double LengthTolerance = 0.05; ///< of which less must not outweigh left and right;
  double Profile = 1.0;          ///< the thickness along them;
  double Chord = 0.35;           ///< how straight their middle parts are;
  double Angle = 0.2;            ///< the angle between the branches at their ends;
  double Twin = 0.6;             ///< whether these are twins.
  // Two terminals differ by:
  double Centricity = 0.2; ///< AGD;
  double Taper = 1.0;      ///< the thickness from the tip inwards.
  /// A pair that is this unlike costs half as much as it is unlike: one long tail must not outweigh all that
  /// fits.
  double Saturation = 0.6;
  /// Terminals without partner: with half of it tails are given up, with half as much again ears are taken for
  /// horns.
  double Unmatched = 0.6;
  double Split = 0.6; ///< branches that split the terminals as none of the other skeleton does
  double Pose = 0.15; ///< terminal branches that lie differently in space
  double Handedness = 0.025; ///< left for right, where all else is equal
  double Surface = 0.3;      ///< a different share in the surface
  double Coverage = 0.1;     ///< length that is not matched
};
}

#endif
