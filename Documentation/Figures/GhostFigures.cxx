// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"
#include "GhostBoundary.h"
#include "SegmentationTransfer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace figures
{
namespace
{
using marrow::GhostBoundary;

/// The limb with a pair of ghost boundaries whose tip is nearest to the eye (z).
const marrow::ChainPair& PairedLimb(const Matched& pair)
{
  const marrow::TransferParameters defaults;
  const marrow::ChainPair* best = nullptr;
  double nearest = -std::numeric_limits<double>::infinity();
  for (const marrow::ChainPair& chain : pair.Match.Chains)
  {
    const auto landmark = marrow::MatchGhostBoundaries(
      marrow::FindGhostBoundaries(pair.SourceMesh, chain.Source, defaults.Theta, defaults.Kernel),
      marrow::FindGhostBoundaries(pair.TargetMesh, chain.Target, defaults.Theta, defaults.Kernel));
    for (const int end : { chain.Source.Front(), chain.Source.Back() })
    {
      const double z = pair.SourceMesh.Skeleton.Graph[end].Position.z();
      if (landmark && z > nearest &&
        pair.SourceMesh.Skeleton.TypeOf(end) == marrow::NodeType::Terminal)
      {
        nearest = z;
        best = &chain;
      }
    }
  }
  if (!best)
  {
    throw std::runtime_error("No limb has a pair of ghost boundaries.");
  }
  return *best;
}

/// A camel, and its head and neck: the branch to the highest terminal.
struct CamelNeck
{
  explicit CamelNeck(const std::string& meshes)
    : Camel(Analyze(ReadMesh(meshes, "camel")))
  {
    double highest = -std::numeric_limits<double>::infinity();
    for (const marrow::Branch& branch : this->Camel.Skeleton.Branches)
    {
      for (const int end : { branch.Front(), branch.Back() })
      {
        const double height = this->Camel.Skeleton.Graph[end].Position.y();
        if (height > highest && this->Camel.Skeleton.TypeOf(end) == marrow::NodeType::Terminal)
        {
          highest = height;
          this->Neck = branch;
        }
      }
    }
  }

  marrow::AnalyzedMesh Camel;
  marrow::Branch Neck;
};

std::vector<Point> ProfileOf(
  const marrow::AnalyzedMesh& side, const marrow::Branch& chain, double kernel)
{
  const std::vector<double> values = marrow::GradientProfile(side, chain, kernel);
  std::vector<Point> profile;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    profile.push_back({ static_cast<double>(i) / (values.size() - 1), values[i] });
  }
  return profile;
}

double Highest(const std::vector<Point>& profile)
{
  double highest = 0.0;
  for (const Point& point : profile)
  {
    highest = std::max(highest, point[1]);
  }
  return highest;
}

double ValueAt(const std::vector<Point>& profile, double ratio)
{
  return profile[static_cast<std::size_t>(std::round(ratio * (profile.size() - 1)))][1];
}

/// The profile in its axes, with a disk at each peak that became a ghost boundary.
void DrawProfile(Canvas& canvas, Axes& axes, const std::vector<Point>& profile,
  const std::vector<GhostBoundary>& ghosts, const Color& color)
{
  axes.Curve(profile, color);
  for (const GhostBoundary& ghost : ghosts)
  {
    canvas.Disk(axes.At(ghost.Peak, ValueAt(profile, ghost.Peak)), 6, color);
  }
}

Picture DrawGhostProfile(const std::string&)
{
  const Matched& pair = Quadrupeds();
  const marrow::ChainPair& chain = PairedLimb(pair);
  const marrow::TransferParameters defaults;
  const std::vector<Point> profiles[2] = { ProfileOf(
                                             pair.SourceMesh, chain.Source, defaults.Kernel),
    ProfileOf(pair.TargetMesh, chain.Target, defaults.Kernel) };
  const std::vector<GhostBoundary> ghosts[2] = { marrow::FindGhostBoundaries(pair.SourceMesh,
                                                   chain.Source, defaults.Theta, defaults.Kernel),
    marrow::FindGhostBoundaries(pair.TargetMesh, chain.Target, defaults.Theta, defaults.Kernel) };
  const auto landmark = marrow::MatchGhostBoundaries(ghosts[0], ghosts[1]);
  Canvas canvas(760, 360);
  // Above the curves there is room for the legend.
  const double top = 1.6 * std::max(Highest(profiles[0]), Highest(profiles[1]));
  Axes axes(canvas, { 75, 55 }, { 740, 335 }, { 0, 0 }, { 1, top });
  axes.Frame("place along the branch (arc ratio)", "mean |MSP gradient|");
  if (landmark)
  {
    const auto ofRatio = [&](int side, double ratio)
    {
      for (const GhostBoundary& ghost : ghosts[side])
      {
        if (ghost.Ratio == ratio)
        {
          return axes.At(ghost.Peak, ValueAt(profiles[side], ghost.Peak));
        }
      }
      return axes.At(ratio, 0.0);
    };
    for (const Point& place : { ofRatio(0, landmark->Source), ofRatio(1, landmark->Target) })
    {
      canvas.Disk(place, 10, Black);
    }
  }
  DrawProfile(canvas, axes, profiles[0], ghosts[0], Blue);
  DrawProfile(canvas, axes, profiles[1], ghosts[1], Vermilion);
  canvas.Text({ 330, 322 }, "source", 15, Canvas::Align::Left, Blue);
  canvas.Text({ 330, 302 }, "target", 15, Canvas::Align::Left, Vermilion);
  canvas.Text({ 330, 282 }, "disks: peaks that stand out", 13, Canvas::Align::Left);
  canvas.Text({ 330, 264 }, "ringed: the pair taken for the same place", 13, Canvas::Align::Left);
  return canvas.Draw();
}

Data EdgesOf(const marrow::TriangleMesh& mesh, const std::vector<int>& halfEdges)
{
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> ends;
  for (const int h : halfEdges)
  {
    ends.emplace_back(mesh.Points[mesh.From(h)], mesh.Points[mesh.To(h)]);
  }
  return Segments(ends);
}

Picture DrawGhostBoundaries(const std::string&)
{
  const Matched& pair = Quadrupeds();
  const marrow::ChainPair& chain = PairedLimb(pair);
  const marrow::TransferParameters defaults;
  const auto scene = Scene(420, 320);
  const auto add = [&](const marrow::AnalyzedMesh& side, const marrow::Branch& branch,
                     const Prepared& shown, const char* caption, const Color& color)
  {
    // The skeletons are not seen but turn the target like the source.
    const int tile = scene->AddMesh(shown.Mesh, shown.Skeleton, caption);
    scene->SetSurfaceArray(tile, "MSPGradient");
    for (const GhostBoundary& ghost :
      marrow::FindGhostBoundaries(side, branch, defaults.Theta, defaults.Kernel))
    {
      scene->AddCurves(
        tile, EdgesOf(side.Mesh, ghost.HalfEdges), color[0], color[1], color[2], 0.005);
    }
  };
  add(pair.SourceMesh, chain.Source, pair.Source, "source", Vermilion);
  add(pair.TargetMesh, chain.Target, pair.Target, "target", Vermilion);
  return Drawn(scene);
}

Picture DrawTheta(const std::string& meshes)
{
  const CamelNeck camel(meshes);
  // A little less smooth than by default, for more peaks to choose from.
  constexpr double kernel = 0.02;
  const std::vector<Point> profile = ProfileOf(camel.Camel, camel.Neck, kernel);
  std::vector<Picture> pictures;
  for (const char* theta : { "1.1", "1.5", "6" })
  {
    Canvas canvas(290, 240);
    Axes axes(canvas, { 65, 50 }, { 280, 205 }, { 0, 0 }, { 1, 1.1 * Highest(profile) });
    axes.Frame("arc ratio", "mean |MSP gradient|");
    DrawProfile(canvas, axes, profile,
      marrow::FindGhostBoundaries(camel.Camel, camel.Neck, std::stod(theta), kernel), Blue);
    canvas.Text({ 172, 225 }, std::string("Theta ") + theta, 15);
    pictures.push_back(canvas.Draw());
  }
  return Beside(pictures);
}

Picture DrawKernel(const std::string& meshes)
{
  const CamelNeck camel(meshes);
  const marrow::TransferParameters defaults;
  std::vector<Picture> pictures;
  for (const char* kernel : { "0.01", "0.05", "0.2" })
  {
    Canvas canvas(290, 240);
    const double top = 1.1 * Highest(ProfileOf(camel.Camel, camel.Neck, 0.01));
    Axes axes(canvas, { 65, 50 }, { 280, 205 }, { 0, 0 }, { 1, top });
    axes.Frame("arc ratio", "mean |MSP gradient|");
    const double width = std::stod(kernel);
    DrawProfile(canvas, axes, ProfileOf(camel.Camel, camel.Neck, width),
      marrow::FindGhostBoundaries(camel.Camel, camel.Neck, defaults.Theta, width), Blue);
    canvas.Text({ 172, 225 }, std::string("Kernel ") + kernel, 15);
    pictures.push_back(canvas.Draw());
  }
  return Beside(pictures);
}
}

Drawings GhostFigures()
{
  return { { "ghost-profile", DrawGhostProfile }, { "ghost-boundaries", DrawGhostBoundaries },
    { "parameter-theta", DrawTheta }, { "parameter-kernel", DrawKernel } };
}
}
