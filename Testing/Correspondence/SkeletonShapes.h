// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonShapes_h
#define marrow_SkeletonShapes_h

#include "Constants.h"
#include "Skeleton.h"
#include "SkeletonBridge.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Skeletons drawn by hand, whose parts have names, with AGD and MSP as a mesh round them would
/// give.
namespace marrow::test
{
/// Points with a name and the lines between them.
class SkeletonShape
{
public:
  /// x is the creature's front, y up, z its left.
  void Point(const std::string& name, double x, double y, double z, double radius)
  {
    this->Points[name] = { Eigen::Vector3d(x, y, z), radius };
  }
  /// Straight lines through the named points, in order.
  void Line(const std::vector<std::string>& names) { this->Lines.push_back(names); }
  void Move(const std::string& name, double x, double y, double z)
  {
    this->Points.at(name).first += Eigen::Vector3d(x, y, z);
  }
  void Transform(const Eigen::Matrix3d& matrix)
  {
    for (auto& point : this->Points)
    {
      point.second.first = matrix * point.second.first;
      point.second.second *= std::cbrt(std::abs(matrix.determinant()));
    }
  }

  /// A skeleton whose nodes are numbered at random by `seed` (0: in the order of the names).
  Skeleton Build(unsigned seed = 0) const
  {
    std::vector<SkeletonNode> nodes;
    std::vector<std::pair<int, int>> edges;
    std::map<std::string, int> numbers;
    for (const auto& [name, point] : this->Points)
    {
      numbers[name] = static_cast<int>(nodes.size());
      nodes.push_back(Node(point.first, point.second));
    }
    for (const auto& line : this->Lines)
    {
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        const auto& a = this->Points.at(line[i - 1]);
        const auto& b = this->Points.at(line[i]);
        constexpr int pieces = 6;
        int last = numbers[line[i - 1]];
        for (int k = 1; k <= pieces; ++k)
        {
          const double t = static_cast<double>(k) / pieces;
          int next = numbers[line[i]];
          if (k < pieces)
          {
            next = static_cast<int>(nodes.size());
            nodes.push_back(
              Node((1.0 - t) * a.first + t * b.first, (1.0 - t) * a.second + t * b.second));
          }
          edges.emplace_back(last, next);
          last = next;
        }
      }
    }
    std::vector<int> order(nodes.size());
    std::iota(order.begin(), order.end(), 0);
    if (seed > 0)
    {
      std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    }
    Skeleton skeleton;
    skeleton.Graph = SkeletonGraph(nodes.size());
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      skeleton.Graph[order[i]] = nodes[i];
      box.extend(nodes[i].Position);
      skeleton.MeshMaximumMSP = std::max(skeleton.MeshMaximumMSP, nodes[i].MSP);
    }
    for (const auto& [a, b] : edges)
    {
      boost::add_edge(order[a], order[b], skeleton.Graph);
    }
    skeleton.MeshDiagonal = 1.1 * box.diagonal().norm();
    skeleton.ExtractBranches();
    AddCentricity(skeleton);
    return skeleton;
  }

  vtkSmartPointer<vtkPolyData> BuildPolyData(unsigned seed = 0) const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    ToPolyData(this->Build(seed), data);
    return data;
  }

  const Eigen::Vector3d& Position(const std::string& name) const
  {
    return this->Points.at(name).first;
  }

  /// The point of the skeleton that has this name.
  vtkIdType Find(vtkPolyData* data, const std::string& name) const
  {
    const Eigen::Vector3d& p = this->Position(name);
    return data->FindPoint(p.x(), p.y(), p.z());
  }

private:
  static SkeletonNode Node(const Eigen::Vector3d& position, double radius)
  {
    SkeletonNode node;
    node.Position = position;
    node.Radius = radius;
    node.MSP = 2.0 * Pi * radius;
    return node;
  }

  /// AGD along the skeleton, each node weighted by the surface round it.
  static void AddCentricity(Skeleton& skeleton)
  {
    const int count = skeleton.NumberOfNodes();
    std::vector<std::vector<std::pair<int, double>>> neighbors(count);
    std::vector<double> weight(count, 0.0);
    for (auto [e, end] = boost::edges(skeleton.Graph); e != end; ++e)
    {
      const int a = static_cast<int>(boost::source(*e, skeleton.Graph));
      const int b = static_cast<int>(boost::target(*e, skeleton.Graph));
      const double length = (skeleton.Graph[a].Position - skeleton.Graph[b].Position).norm();
      neighbors[a].emplace_back(b, length);
      neighbors[b].emplace_back(a, length);
      weight[a] += length * skeleton.Graph[a].Radius;
      weight[b] += length * skeleton.Graph[b].Radius;
    }
    std::vector<double> centricity(count, 0.0);
    for (int start = 0; start < count; ++start)
    {
      std::vector<double> distance(count, 1e30);
      std::priority_queue<std::pair<double, int>> open;
      distance[start] = 0.0;
      open.emplace(0.0, start);
      while (!open.empty())
      {
        const auto [d, node] = open.top();
        open.pop();
        for (const auto& [next, length] : neighbors[node])
        {
          if (-d + length < distance[next])
          {
            distance[next] = -d + length;
            open.emplace(-distance[next], next);
          }
        }
      }
      for (int n = 0; n < count; ++n)
      {
        // Other components count as far as the diagonal.
        centricity[start] += weight[n] * std::min(distance[n], skeleton.MeshDiagonal);
      }
    }
    const auto [least, most] = std::minmax_element(centricity.begin(), centricity.end());
    const double range = *most - *least;
    for (int n = 0; n < count; ++n)
    {
      skeleton.Graph[n].AGD = range > 0.0 ? (centricity[n] - *least) / range : 0.0;
    }
  }

  std::map<std::string, std::pair<Eigen::Vector3d, double>> Points;
  std::vector<std::vector<std::string>> Lines;
};

/// Head, tail and four legs, the hind ones longer.
inline SkeletonShape MakeQuadruped()
{
  SkeletonShape shape;
  shape.Point("chest", 1.0, 1.0, 0.0, 0.24);
  shape.Point("hip", 0.0, 1.05, 0.0, 0.22);
  shape.Point("neck", 1.4, 1.4, 0.0, 0.15);
  shape.Point("head", 1.9, 1.5, 0.0, 0.12);
  shape.Point("tailbase", -0.3, 1.0, 0.0, 0.06);
  shape.Point("tail", -0.8, 0.7, 0.0, 0.03);
  for (const auto& [side, z] : { std::pair{ "left", 0.25 }, std::pair{ "right", -0.25 } })
  {
    const std::string s(side);
    shape.Point("fore knee " + s, 1.05, 0.5, z, 0.09);
    shape.Point("fore " + s, 1.0, 0.0, z, 0.06);
    shape.Point("hind knee " + s, -0.1, 0.5, 1.1 * z, 0.11);
    shape.Point("hind " + s, -0.15, -0.1, 1.1 * z, 0.07);
    shape.Line({ "chest", "fore knee " + s, "fore " + s });
    shape.Line({ "hip", "hind knee " + s, "hind " + s });
  }
  shape.Line({ "hip", "chest" });
  shape.Line({ "chest", "neck", "head" });
  shape.Line({ "hip", "tailbase", "tail" });
  return shape;
}

inline const std::vector<std::string>& QuadrupedTerminals()
{
  static const std::vector<std::string> names{ "head", "tail", "fore left", "fore right",
    "hind left", "hind right" };
  return names;
}

/// `arms` alike arms round a centre, and a head above it.
inline SkeletonShape MakeStar(int arms)
{
  SkeletonShape shape;
  shape.Point("center", 0.0, 0.0, 0.0, 0.3);
  shape.Point("head", 0.0, 0.8, 0.0, 0.35);
  shape.Line({ "center", "head" });
  for (int i = 0; i < arms; ++i)
  {
    const double angle = 2.0 * Pi * i / arms;
    // Not quite alike, or no arm could be told from its neighbour turned by one place.
    const double length = 2.0 + 0.1 * std::sin(3.0 * i);
    const std::string name = "arm " + std::to_string(i);
    shape.Point(name, length * std::cos(angle), -0.3, length * std::sin(angle), 0.05);
    shape.Line({ "center", name });
  }
  return shape;
}

/// Four legs, a seat, a back of two posts with a rail between them: one loop.
inline SkeletonShape MakeChair()
{
  SkeletonShape shape;
  shape.Point("seat", 0.0, 0.0, 0.0, 0.2);
  shape.Point("post left", -0.5, 0.1, 0.45, 0.06);
  shape.Point("post right", -0.5, 0.1, -0.45, 0.06);
  shape.Point("rail left", -0.6, 1.0, 0.45, 0.06);
  shape.Point("rail right", -0.6, 1.0, -0.45, 0.06);
  for (const auto& [name, x, z] :
    { std::tuple{ "front left", 0.5, 0.5 }, std::tuple{ "front right", 0.5, -0.5 },
      std::tuple{ "back left", -0.45, 0.5 }, std::tuple{ "back right", -0.45, -0.5 } })
  {
    shape.Point(name, x, x > 0.0 ? -1.0 : -0.9, z, 0.05);
    shape.Line({ "seat", name });
  }
  shape.Line({ "seat", "post left", "rail left", "rail right", "post right", "seat" });
  return shape;
}

/// A chain of bends that thins from its head on.
inline SkeletonShape MakeSnake(double bend)
{
  SkeletonShape shape;
  std::vector<std::string> names;
  for (int i = 0; i <= 8; ++i)
  {
    const std::string name = i == 0 ? "head" : i == 8 ? "tail" : "body " + std::to_string(i);
    shape.Point(name, i, bend * std::sin(1.3 * i), 0.0, i == 0 ? 0.4 : 0.35 - 0.035 * i);
    names.push_back(name);
  }
  shape.Line(names);
  return shape;
}

/// A closed ring of varying thickness.
inline SkeletonShape MakeRing()
{
  SkeletonShape shape;
  std::vector<std::string> names;
  for (int i = 0; i < 12; ++i)
  {
    const double angle = 2.0 * Pi * i / 12;
    names.push_back("ring " + std::string(1, static_cast<char>('a' + i)));
    shape.Point(names.back(), std::cos(angle), std::sin(angle), 0.0, 0.2 + 0.05 * std::cos(angle));
  }
  names.push_back(names.front());
  shape.Line(names);
  return shape;
}
}

#endif
