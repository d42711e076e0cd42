// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonMap.h"

#include "BestRotation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace marrow
{
namespace
{
/// The part of a chain at its end, of its length, whose direction counts: at least this and the junction's ball.
constexpr double LeastEnd = 0.1;
/// A radius is the mean over five places this far apart, of the length: single ones jump.
constexpr double RadiusStep = 0.04;
/// Of the diagonal: a limb without thickness has a scale all the same.
constexpr double LeastRadius = 1e-6;
/// A tangent is that of a piece of the chain of at least this length, of the chain's: shorter ones are noise.
constexpr double LeastReach = 0.05;
/// Of the rotation of the whole beside the vectors of a junction, which have 1 each.
constexpr double WeightOfWhole = 0.05;
/// How much thicker or thinner than the whole a limb may become: more is a mistake of the matching.
constexpr double MostScale = 5.0;
/// How much longer than wide a limb may become, likewise.
constexpr double MostStretch = 3.0;

Eigen::Matrix3d LeastRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

/// Branch vector of T:4.2: the direction of the part of the chain inside the ball at its end.
Eigen::Vector3d EndVector(const Skeleton& skeleton, const Branch& chain, bool back)
{
  const int end = back ? chain.Back() : chain.Front();
  const double reach = std::clamp(skeleton.Graph[end].Radius / chain.Length(), LeastEnd, 0.5);
  const Eigen::Vector3d vector =
    PointOnChain(skeleton, chain, back ? 1.0 - reach : reach) - skeleton.Graph[end].Position;
  return vector.norm() > 0.0 ? Eigen::Vector3d(vector.normalized()) : Eigen::Vector3d::Zero();
}

double RadiusAt(const AnalyzedMesh& side, const Branch& chain, double ratio)
{
  // A mean over a short stretch: single nodes near joints are unsteady.
  double sum = 0.0;
  for (int k = -2; k <= 2; ++k)
  {
    sum += InterpolateOnChain(
      chain, ratio + RadiusStep * k, [&](int node) { return side.Skeleton.Graph[node].Radius; });
  }
  return std::max(sum / 5.0, LeastRadius * side.Diagonal());
}

double TangentReach(const AnalyzedMesh& side, const Branch& chain, double ratio)
{
  return std::clamp(
    RadiusAt(side, chain, ratio), LeastReach * chain.Length(), 0.25 * chain.Length());
}
}

SkeletonMap::SkeletonMap(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, std::vector<ChainAlignment> alignments)
  : Source(source)
  , Target(target)
  , Match(match)
  , Frames(match.Chains.size())
  , Alignments(std::move(alignments))
{
  this->ComputeGlobalRotation();
  for (std::size_t c = 0; c < match.Chains.size(); ++c)
  {
    this->ComputeChainFrames(static_cast<int>(c));
  }
}

void SkeletonMap::ComputeGlobalRotation()
{
  std::vector<Eigen::Vector3d> sources;
  std::vector<Eigen::Vector3d> targets;
  std::vector<double> weights;
  Eigen::Vector3d sourceMean = Eigen::Vector3d::Zero();
  Eigen::Vector3d targetMean = Eigen::Vector3d::Zero();
  double total = 0.0;
  for (const ChainPair& pair : this->Match.Chains)
  {
    const double weight = pair.Source.Length() / std::max(this->Source.Diagonal(), 1e-300) +
      pair.Target.Length() / std::max(this->Target.Diagonal(), 1e-300);
    for (int k = 0; k <= 8; ++k)
    {
      sources.push_back(PointOnChain(this->Source.Skeleton, pair.Source, k / 8.0));
      targets.push_back(PointOnChain(this->Target.Skeleton, pair.Target, k / 8.0));
      weights.push_back(weight);
      sourceMean += weight * sources.back();
      targetMean += weight * targets.back();
      total += weight;
    }
  }
  if (total <= 0.0)
  {
    return;
  }
  sourceMean /= total;
  targetMean /= total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    covariance += weights[i] * (sources[i] - sourceMean) * (targets[i] - targetMean).transpose();
  }
  this->Global = BestRotation(covariance);
}

Eigen::Matrix3d SkeletonMap::EndRotation(int chain, bool back, int& numberOfVectors) const
{
  const ChainPair& at = this->Match.Chains[chain];
  const int sourceEnd = back ? at.Source.Back() : at.Source.Front();
  const int targetEnd = back ? at.Target.Back() : at.Target.Front();
  const int sourceId = this->Match.Ids.SourceNodes[sourceEnd];
  const int targetId = this->Match.Ids.TargetNodes[targetEnd];
  const auto meets = [](int node, int id, int end, int endId)
  { return node == end || (id >= 0 && id == endId); };

  // The whole's rotation, with little weight, settles what one or two vectors leave open.
  Eigen::Matrix3d covariance = WeightOfWhole * this->Global;
  numberOfVectors = 0;
  for (const ChainPair& pair : this->Match.Chains)
  {
    for (bool pairBack : { false, true })
    {
      const int s = pairBack ? pair.Source.Back() : pair.Source.Front();
      const int t = pairBack ? pair.Target.Back() : pair.Target.Front();
      if (meets(s, this->Match.Ids.SourceNodes[s], sourceEnd, sourceId) &&
        meets(t, this->Match.Ids.TargetNodes[t], targetEnd, targetId))
      {
        covariance += EndVector(this->Source.Skeleton, pair.Source, pairBack) *
          EndVector(this->Target.Skeleton, pair.Target, pairBack).transpose();
        ++numberOfVectors;
      }
    }
  }
  return BestRotation(covariance);
}

void SkeletonMap::ComputeChainFrames(int chain)
{
  const ChainPair& pair = this->Match.Chains[chain];
  ChainFrames& frames = this->Frames[chain];
  frames.Rotations.assign(NumberOfSamples, Eigen::Matrix3d::Identity());
  frames.Scales.assign(NumberOfSamples, 1.0);
  std::vector<Eigen::Vector3d> sourceTangents(NumberOfSamples);
  std::vector<Eigen::Vector3d> targetTangents(NumberOfSamples);
  const double wholeScale =
    this->Target.Diagonal() > 0.0 ? this->Source.Diagonal() / this->Target.Diagonal() : 1.0;
  for (int k = 0; k < NumberOfSamples; ++k)
  {
    const double s = static_cast<double>(k) / (NumberOfSamples - 1);
    const double t = this->TargetRatio(chain, s);
    sourceTangents[k] = TangentOfChain(
      this->Source.Skeleton, pair.Source, s, TangentReach(this->Source, pair.Source, s));
    targetTangents[k] = TangentOfChain(
      this->Target.Skeleton, pair.Target, t, TangentReach(this->Target, pair.Target, t));
    const double scale =
      RadiusAt(this->Source, pair.Source, s) / RadiusAt(this->Target, pair.Target, t);
    frames.Scales[k] = std::clamp(scale, wholeScale / MostScale, MostScale * wholeScale);
  }

  int frontVectors = 0;
  int backVectors = 0;
  const Eigen::Matrix3d front = this->EndRotation(chain, false, frontVectors);
  const Eigen::Matrix3d back = this->EndRotation(chain, true, backVectors);
  const bool useBack = backVectors > 1;
  const bool useFront = frontVectors > 1 || !useBack;
  const auto align = [&](const Eigen::Matrix3d& rotation, int k) -> Eigen::Matrix3d
  { return LeastRotation(rotation * targetTangents[k], sourceTangents[k]) * rotation; };
  const auto carry = [&](const Eigen::Matrix3d& rotation, int from, int to) -> Eigen::Matrix3d
  {
    return LeastRotation(sourceTangents[from], sourceTangents[to]) * rotation *
      LeastRotation(targetTangents[to], targetTangents[from]);
  };
  std::vector<Eigen::Matrix3d> fromBack(NumberOfSamples);
  const int last = NumberOfSamples - 1;
  fromBack[last] = align(back, last);
  for (int k = last - 1; k >= 0; --k)
  {
    fromBack[k] = carry(fromBack[k + 1], k + 1, k);
  }
  Eigen::Matrix3d fromFront = align(front, 0);
  for (int k = 0; k < NumberOfSamples; ++k)
  {
    if (k > 0)
    {
      fromFront = carry(fromFront, k - 1, k);
    }
    const double weight = useBack ? (useFront ? static_cast<double>(k) / last : 1.0) : 0.0;
    frames.Rotations[k] = Eigen::Quaterniond(fromFront)
                            .slerp(weight, Eigen::Quaterniond(fromBack[k]))
                            .toRotationMatrix();
  }
}

Eigen::Matrix3d SkeletonMap::Rotation(int chain, double sourceRatio) const
{
  const double at = std::clamp(sourceRatio, 0.0, 1.0) * (NumberOfSamples - 1);
  const int index = std::min(static_cast<int>(at), NumberOfSamples - 2);
  const auto& rotations = this->Frames[chain].Rotations;
  return Eigen::Quaterniond(rotations[index])
    .slerp(at - index, Eigen::Quaterniond(rotations[index + 1]))
    .toRotationMatrix();
}

double SkeletonMap::RadialScale(int chain, double sourceRatio) const
{
  const double at = std::clamp(sourceRatio, 0.0, 1.0) * (NumberOfSamples - 1);
  const int index = std::min(static_cast<int>(at), NumberOfSamples - 2);
  const auto& scales = this->Frames[chain].Scales;
  return scales[index] + (at - index) * (scales[index + 1] - scales[index]);
}

SkeletonMap::Place SkeletonMap::PlaceOnChain(int chain, double targetRatio) const
{
  const ChainPair& pair = this->Match.Chains[chain];
  const double s = this->SourceRatio(chain, targetRatio);
  const ChainPosition at = LocateOnChain(pair.Source, s);
  Place place;
  place.Known = true;
  place.Matched = true;
  place.SourceNode = pair.Source.Nodes[at.Index + (at.Fraction > 0.5 ? 1 : 0)];
  place.Radius = RadiusAt(this->Source, pair.Source, s);

  // Lengths along the chain scale as the chain does, lengths across it as its radius.
  const double radial = this->RadialScale(chain, s);
  constexpr double step =
    0.02; // of the chain: over shorter ones the slope of the alignment is noise
  const double slope = (this->SourceRatio(chain, std::min(targetRatio + step, 1.0)) -
                         this->SourceRatio(chain, std::max(targetRatio - step, 0.0))) /
    (std::min(targetRatio + step, 1.0) - std::max(targetRatio - step, 0.0));
  const double axial = std::clamp(slope * pair.Source.Length() / pair.Target.Length(),
    radial / MostStretch, MostStretch * radial);
  const Eigen::Vector3d tangent = TangentOfChain(this->Target.Skeleton, pair.Target, targetRatio,
    TangentReach(this->Target, pair.Target, targetRatio));
  const Eigen::Matrix3d linear = this->Rotation(chain, s) *
    (radial * Eigen::Matrix3d::Identity() + (axial - radial) * tangent * tangent.transpose());
  place.Transform.leftCols<3>() = linear;
  place.Transform.col(3) = PointOnChain(this->Source.Skeleton, pair.Source, s) -
    linear * PointOnChain(this->Target.Skeleton, pair.Target, targetRatio);
  return place;
}

SkeletonMap::Place SkeletonMap::PlaceOfEnds(int targetNode) const
{
  // A junction: its branches' frames agree on one rotation, its place is where their ends are.
  Place place;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double radius = 0.0;
  int count = 0;
  for (std::size_t c = 0; c < this->Match.Chains.size(); ++c)
  {
    const ChainPair& pair = this->Match.Chains[c];
    for (bool back : { false, true })
    {
      if ((back ? pair.Target.Back() : pair.Target.Front()) != targetNode)
      {
        continue;
      }
      const int sourceNode = back ? pair.Source.Back() : pair.Source.Front();
      if (count == 0)
      {
        int vectors = 0;
        rotation = this->EndRotation(static_cast<int>(c), back, vectors);
        place.SourceNode = sourceNode;
        if (vectors < 2)
        {
          return this->PlaceOnChain(static_cast<int>(c), back ? 1.0 : 0.0);
        }
      }
      position += this->Source.Skeleton.Graph[sourceNode].Position;
      radius += this->Source.Skeleton.Graph[sourceNode].Radius;
      ++count;
    }
  }
  if (count == 0)
  {
    return place;
  }
  place.Known = true;
  place.Matched = true;
  place.Radius = radius / count;
  const double wholeScale =
    this->Target.Diagonal() > 0.0 ? this->Source.Diagonal() / this->Target.Diagonal() : 1.0;
  const double targetRadius =
    std::max(this->Target.Skeleton.Graph[targetNode].Radius, LeastRadius * this->Target.Diagonal());
  const double scale =
    std::clamp(place.Radius / targetRadius, wholeScale / MostScale, MostScale * wholeScale);
  place.Transform.leftCols<3>() = scale * rotation;
  place.Transform.col(3) =
    position / count - scale * rotation * this->Target.Skeleton.Graph[targetNode].Position;
  return place;
}

std::vector<SkeletonMap::Place> SkeletonMap::PlacesOfTargetNodes() const
{
  const SkeletonGraph& graph = this->Target.Skeleton.Graph;
  const int numberOfNodes = this->Target.Skeleton.NumberOfNodes();
  std::vector<Place> places(numberOfNodes);
  for (std::size_t c = 0; c < this->Match.Chains.size(); ++c)
  {
    const Branch& chain = this->Match.Chains[c].Target;
    for (std::size_t i = 1; i + 1 < chain.Nodes.size(); ++i)
    {
      places[chain.Nodes[i]] =
        this->PlaceOnChain(static_cast<int>(c), chain.ArcLength[i] / chain.Length());
    }
  }
  for (int n = 0; n < numberOfNodes; ++n)
  {
    if (!places[n].Known)
    {
      places[n] = this->PlaceOfEnds(n);
    }
  }

  // What is left hangs on the matched node that is nearest along the skeleton.
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  std::vector<double> distance(numberOfNodes, std::numeric_limits<double>::infinity());
  for (int n = 0; n < numberOfNodes; ++n)
  {
    if (places[n].Known)
    {
      distance[n] = 0.0;
      heap.push({ 0.0, n });
    }
  }
  while (!heap.empty())
  {
    const auto [reached, node] = heap.top();
    heap.pop();
    if (reached > distance[node])
    {
      continue;
    }
    for (auto [e, end] = boost::out_edges(node, graph); e != end; ++e)
    {
      const int next = static_cast<int>(boost::target(*e, graph));
      const double sum = reached + (graph[next].Position - graph[node].Position).norm();
      if (sum < distance[next])
      {
        distance[next] = sum;
        places[next] = places[node];
        places[next].Matched = false;
        heap.push({ sum, next });
      }
    }
  }
  return places;
}

std::vector<bool> SkeletonMap::MatchedSourceNodes() const
{
  std::vector<bool> matched(this->Source.Skeleton.NumberOfNodes(), false);
  for (const ChainPair& pair : this->Match.Chains)
  {
    for (int node : pair.Source.Nodes)
    {
      matched[node] = true;
    }
  }
  for (std::size_t n = 0; n < matched.size(); ++n)
  {
    matched[n] = matched[n] || this->Match.Ids.SourceNodes[n] >= 0;
  }
  return matched;
}
}
