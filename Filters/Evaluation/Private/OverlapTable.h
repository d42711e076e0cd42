// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_OverlapTable_h
#define marrow_OverlapTable_h

#include <cstddef>
#include <vector>

namespace marrow
{
/// How two segmentations of the same faces overlap: only the pairs of segments that share a face,
/// so that even one segment a face costs no more than O(n log n).
class OverlapTable
{
public:
  /// The ids may be any integers; `areas` are those of the faces.
  OverlapTable(const std::vector<int>& segments, const std::vector<int>& reference,
    const std::vector<double>& areas);

  /// Share of the pairs of faces that are in one segment in the one and in two in the other.
  double RandError() const;

  /// Share of the area that is outside of the best match of its segment: of each segment of the
  /// reference among the segments (missing rate), or of each segment among those of the reference
  /// (false alarm rate).
  double MissingRate() const;
  double FalseAlarmRate() const;

  /// Martin et al. 2001: the mean over the faces of how much of the face's segment lies outside of
  /// its segment in the other segmentation; whichever way is less, for the whole (global) or for each
  /// face (local). 0 where one refines the other.
  double GlobalConsistencyError() const;
  double LocalConsistencyError() const;

private:
  struct Overlap
  {
    int Segment = 0;   ///< row
    int Reference = 0; ///< column
    double Faces = 0.0;
    double Area = 0.0;
  };

  /// Share of the area; `side` is a member of Overlap with values below `size`.
  double AreaOutsideOfBestMatch(std::size_t size, int Overlap::*side) const;

  std::vector<Overlap> Overlaps;
  std::vector<double> SegmentFaces;   ///< per row
  std::vector<double> ReferenceFaces; ///< per column
  double TotalFaces = 0.0;
  double TotalArea = 0.0;
};
}

#endif
