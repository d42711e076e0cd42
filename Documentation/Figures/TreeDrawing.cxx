// SPDX-License-Identifier: BSD-3-Clause
#include "TreeDrawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace figures
{
namespace
{
constexpr std::size_t MostLeaves = 12;
constexpr int RowHeight = 34;
constexpr int SkeletonWidth = 200;

/// The tree as far as it leads to the leaves that are drawn. Steps without a choice are one node.
struct Step
{
  std::vector<std::string> Pairs;
  bool Merges = false;
  int Leaf = -1;
  std::vector<Step> Children;
  double Row = 0.0;
};

std::string Letters(const marrow::FeatureGroup& group, char first)
{
  std::string letters;
  for (const int feature : group.Features)
  {
    letters += static_cast<char>(first + feature);
  }
  return letters;
}

struct NamedPair
{
  std::string Name;
  bool IsMerged;
};

std::vector<NamedPair> PairsOf(const marrow::RatedLeaf& leaf)
{
  std::vector<NamedPair> pairs;
  for (const marrow::MatchedNodes& nodes : leaf.Match.Nodes)
  {
    pairs.push_back({ Letters(nodes.Source, 'A') + "-" + Letters(nodes.Target, 'a'),
      nodes.Source.Features.size() + nodes.Target.Features.size() > 2 });
  }
  return pairs;
}

/// The steps of the leaves from `depth` on; all of them agree up to there.
std::vector<Step> Branch(const std::vector<std::vector<NamedPair>>& paths,
  const std::vector<int>& leaves, std::size_t depth)
{
  std::vector<Step> steps;
  std::vector<std::vector<int>> groups;
  for (const int leaf : leaves)
  {
    if (depth >= paths[leaf].size())
    {
      continue;
    }
    const NamedPair& pair = paths[leaf][depth];
    const auto same = std::find_if(steps.begin(), steps.end(),
      [&](const Step& step) { return step.Pairs.front() == pair.Name; });
    if (same == steps.end())
    {
      Step step;
      step.Pairs = { pair.Name };
      step.Merges = pair.IsMerged;
      steps.push_back(step);
      groups.push_back({ leaf });
    }
    else
    {
      groups[same - steps.begin()].push_back(leaf);
    }
  }
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    Step& step = steps[i];
    step.Children = Branch(paths, groups[i], depth + 1);
    if (step.Children.empty())
    {
      step.Leaf = groups[i].front();
    }
    else if (step.Children.size() == 1)
    {
      Step only = step.Children.front();
      only.Pairs.insert(only.Pairs.begin(), step.Pairs.begin(), step.Pairs.end());
      only.Merges = only.Merges || step.Merges;
      step = only;
    }
  }
  return steps;
}

int PlaceRows(std::vector<Step>& steps, int row)
{
  for (Step& step : steps)
  {
    const int first = row;
    row = step.Children.empty() ? row + 1 : PlaceRows(step.Children, row);
    step.Row = 0.5 * (first + row - 1);
  }
  return row;
}

std::string TextOf(const Step& step)
{
  std::string text;
  for (const std::string& pair : step.Pairs)
  {
    text += (text.empty() ? "" : "  ") + pair;
  }
  return text;
}

double WidthOf(const Step& step)
{
  return 9.0 * TextOf(step).size() + 14.0;
}

class Drawing
{
public:
  Drawing(Canvas& canvas, const std::vector<marrow::RatedLeaf>& leaves, double top, double right)
    : Sheet(canvas)
    , Leaves(leaves)
    , Top(top)
    , Right(right)
  {
  }

  void Draw(const std::vector<Step>& steps, const Point& from)
  {
    for (const Step& step : steps)
    {
      const bool wins = this->HoldsWinner(step);
      const Color& color = wins ? Vermilion : Grey;
      const double y = this->Top - step.Row * RowHeight;
      const double x = from[0] + 36.0;
      this->Sheet.Lines({ from, { x, y } }, color, wins ? 2.5 : 1.2);
      const double width = WidthOf(step);
      this->Sheet.Box({ x, y - 11 }, { x + width, y + 11 }, color);
      this->Sheet.Box({ x + 1.5, y - 9.5 }, { x + width - 1.5, y + 9.5 },
        step.Merges ? Color{ 0.86, 0.92, 1.0 } : Color{ 1.0, 1.0, 1.0 });
      this->Sheet.Text({ x + 0.5 * width, y }, TextOf(step), 13);
      this->Draw(step.Children, { x + width, y });
      if (step.Leaf >= 0)
      {
        char cost[32];
        std::snprintf(cost, sizeof(cost), "%.3f", this->Leaves[step.Leaf].GlobalCost);
        this->Sheet.Text(
          { this->Right, y }, cost, 13, Canvas::Align::Right, wins ? Vermilion : Black);
      }
    }
  }

private:
  bool HoldsWinner(const Step& step) const
  {
    return step.Leaf == 0 ||
      std::any_of(step.Children.begin(), step.Children.end(),
        [&](const Step& child) { return this->HoldsWinner(child); });
  }

  Canvas& Sheet;
  const std::vector<marrow::RatedLeaf>& Leaves;
  double Top;
  double Right;
};

/// The skeleton from the front (x), fitted into a box, with its letters.
void DrawSkeleton(Canvas& canvas, const marrow::Skeleton& skeleton,
  const marrow::FeatureGraph& graph, const Point& low, const Point& high, char firstLetter,
  const std::string& name)
{
  Eigen::Vector2d least(1e300, 1e300);
  Eigen::Vector2d largest(-1e300, -1e300);
  const auto flat = [&](int node)
  {
    const Eigen::Vector3d& p = skeleton.Graph[node].Position;
    return Eigen::Vector2d(-p.z(), p.y());
  };
  for (int node = 0; node < skeleton.NumberOfNodes(); ++node)
  {
    least = least.cwiseMin(flat(node));
    largest = largest.cwiseMax(flat(node));
  }
  const double scale = std::min(
    (high[0] - low[0]) / (largest.x() - least.x()), (high[1] - low[1]) / (largest.y() - least.y()));
  const auto place = [&](int node) -> Point
  {
    const Eigen::Vector2d p = scale * (flat(node) - 0.5 * (least + largest));
    return { 0.5 * (low[0] + high[0]) + p.x(), 0.5 * (low[1] + high[1]) + p.y() };
  };
  for (const marrow::Branch& branch : skeleton.Branches)
  {
    std::vector<Point> points;
    for (const int node : branch.Nodes)
    {
      points.push_back(place(node));
    }
    canvas.Lines(points, Grey, 3);
  }
  for (int feature = 0; feature < graph.NumberOfFeatures(); ++feature)
  {
    const auto& shown = graph.GetFeatures()[feature];
    const Point at = place(shown.Node);
    canvas.Disk(at, 10, shown.IsTerminal() ? Blue : Vermilion);
    canvas.Text(at, std::string(1, static_cast<char>(firstLetter + feature)), 13,
      Canvas::Align::Center, { 1.0, 1.0, 1.0 });
  }
  canvas.Text({ 0.5 * (low[0] + high[0]), low[1] - 26 }, name, 14);
}
}

Picture DrawCorrespondenceTree(const marrow::Skeleton& source,
  const marrow::FeatureGraph& sourceGraph, const marrow::Skeleton& target,
  const marrow::FeatureGraph& targetGraph, const std::vector<marrow::RatedLeaf>& leaves)
{
  const std::size_t count = std::min(MostLeaves, leaves.size());
  std::vector<std::vector<NamedPair>> paths;
  std::vector<int> drawn;
  for (std::size_t i = 0; i < count; ++i)
  {
    paths.push_back(PairsOf(leaves[i]));
    drawn.push_back(static_cast<int>(i));
  }
  std::vector<Step> steps = Branch(paths, drawn, 0);
  const int rows = PlaceRows(steps, 0);
  const int height = std::max(RowHeight * rows + 60, 480);
  constexpr int width = 880;
  Canvas canvas(width, height);
  DrawSkeleton(canvas, source, sourceGraph, { 25, height / 2.0 + 45 },
    { SkeletonWidth - 15, height - 20.0 }, 'A', "source");
  DrawSkeleton(canvas, target, targetGraph, { 25, 50 }, { SkeletonWidth - 15, height / 2.0 - 25 },
    'a', "target");
  const double top = height - 45.0;
  canvas.Text({ width - 12.0, height - 14.0 }, "cost", 13, Canvas::Align::Right);
  Drawing drawing(canvas, leaves, top, width - 12.0);
  const Point root = { SkeletonWidth + 25.0, top - 0.5 * (rows - 1) * RowHeight };
  drawing.Draw(steps, root);
  canvas.Disk(root, 6, Black);
  canvas.Text({ SkeletonWidth + 20.0, 14.0 },
    "the best " + std::to_string(count) + " of " + std::to_string(leaves.size()) +
      " leaves; blue: junctions were merged; vermilion: the way to the winner",
    13, Canvas::Align::Left);
  return canvas.Draw();
}
}
