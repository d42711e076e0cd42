// SPDX-License-Identifier: BSD-3-Clause
#include "OverlapTable.h"

#include <algorithm>
#include <numeric>

namespace marrow
{
namespace
{
/// Numbers any ids from 0, in ascending order; returns how many there are.
int NumberFromZero(const std::vector<int>& ids, std::vector<int>& numbers)
{
  std::vector<int> distinct = ids;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  numbers.resize(ids.size());
  std::transform(ids.begin(), ids.end(), numbers.begin(),
    [&](int id)
    {
      return static_cast<int>(
        std::lower_bound(distinct.begin(), distinct.end(), id) - distinct.begin());
    });
  return static_cast<int>(distinct.size());
}

double PairsAmong(double faces)
{
  return 0.5 * faces * (faces - 1.0);
}
}

OverlapTable::OverlapTable(const std::vector<int>& segments, const std::vector<int>& reference,
  const std::vector<double>& areas)
{
  std::vector<int> rows, columns;
  this->SegmentFaces.assign(NumberFromZero(segments, rows), 0.0);
  this->ReferenceFaces.assign(NumberFromZero(reference, columns), 0.0);
  std::vector<int> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b) { return rows[a] != rows[b] ? rows[a] < rows[b] : columns[a] < columns[b]; });
  for (const int face : order)
  {
    if (this->Overlaps.empty() || this->Overlaps.back().Segment != rows[face] ||
      this->Overlaps.back().Reference != columns[face])
    {
      this->Overlaps.push_back({ rows[face], columns[face], 0.0, 0.0 });
    }
    this->Overlaps.back().Faces += 1.0;
    this->Overlaps.back().Area += areas[face];
    this->SegmentFaces[rows[face]] += 1.0;
    this->ReferenceFaces[columns[face]] += 1.0;
    this->TotalFaces += 1.0;
    this->TotalArea += areas[face];
  }
}

double OverlapTable::RandError() const
{
  const auto pairsInside = [](double sum, double faces) { return sum + PairsAmong(faces); };
  const double inSegment =
    std::accumulate(this->SegmentFaces.begin(), this->SegmentFaces.end(), 0.0, pairsInside);
  const double inReference =
    std::accumulate(this->ReferenceFaces.begin(), this->ReferenceFaces.end(), 0.0, pairsInside);
  double inBoth = 0.0;
  for (const Overlap& overlap : this->Overlaps)
  {
    inBoth += PairsAmong(overlap.Faces);
  }
  const double pairs = PairsAmong(this->TotalFaces);
  return pairs > 0.0 ? (inSegment + inReference - 2.0 * inBoth) / pairs : 0.0;
}

double OverlapTable::MissingRate() const
{
  return this->AreaOutsideOfBestMatch(this->ReferenceFaces.size(), &Overlap::Reference);
}

double OverlapTable::FalseAlarmRate() const
{
  return this->AreaOutsideOfBestMatch(this->SegmentFaces.size(), &Overlap::Segment);
}

double OverlapTable::AreaOutsideOfBestMatch(std::size_t size, int Overlap::*side) const
{
  std::vector<double> best(size, 0.0);
  std::vector<double> all(size, 0.0);
  for (const Overlap& overlap : this->Overlaps)
  {
    const int i = overlap.*side;
    best[i] = std::max(best[i], overlap.Area);
    all[i] += overlap.Area;
  }
  double outside = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    outside += all[i] - best[i];
  }
  return outside / this->TotalArea;
}

double OverlapTable::GlobalConsistencyError() const
{
  double segmentRefines = 0.0;
  double referenceRefines = 0.0;
  for (const Overlap& overlap : this->Overlaps)
  {
    segmentRefines += overlap.Faces * (1.0 - overlap.Faces / this->SegmentFaces[overlap.Segment]);
    referenceRefines +=
      overlap.Faces * (1.0 - overlap.Faces / this->ReferenceFaces[overlap.Reference]);
  }
  return std::min(segmentRefines, referenceRefines) / this->TotalFaces;
}

double OverlapTable::LocalConsistencyError() const
{
  double sum = 0.0;
  for (const Overlap& overlap : this->Overlaps)
  {
    const double smaller =
      std::min(this->SegmentFaces[overlap.Segment], this->ReferenceFaces[overlap.Reference]);
    sum += overlap.Faces * (1.0 - overlap.Faces / smaller);
  }
  return sum / this->TotalFaces;
}
}
