// SPDX-License-Identifier: BSD-3-Clause
#include "PartRelations.h"

#include "MeshCheck.h"
#include "TriangleTree.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

namespace marrow
{
namespace
{
struct Part
{
  double Area = 0.0;
  double BorderLength = 0.0;
  Eigen::Vector3d Low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d High = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Vector3d Moment = Eigen::Vector3d::Zero(); ///< area times middle
  std::vector<int> Triangles;
  std::unique_ptr<TriangleTree> Tree;

  bool Overlaps(const Part& other, double nearness) const
  {
    return (this->Low.array() <= other.High.array() + nearness).all() &&
      (other.Low.array() <= this->High.array() + nearness).all();
  }
};

/// Twice what neighbouring single precision numbers differ by at the largest coordinate.
double SingleRounding(const TriangleMesh& mesh)
{
  double largest = 0.0;
  for (const auto& point : mesh.Points)
  {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  return 2.0 * std::numeric_limits<float>::epsilon() * largest;
}

enum class Relation
{
  Apart,
  Inside,
  Touching
};

class Relating
{
public:
  Relating(const TriangleMesh& mesh, double resolution)
    : Mesh(mesh)
    , Resolution(resolution)
    , Nearness(SingleRounding(mesh))
  {
    int count = 0;
    std::vector<int> component = TriangleComponents(mesh, count);
    std::vector<Part> parts(count);
    for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      Part& part = parts[component[t]];
      const double area = mesh.Area(t);
      part.Area += area;
      part.Moment += area * mesh.Centroid(t);
      part.Triangles.push_back(t);
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Eigen::Vector3d& point = mesh.Points[mesh.From(h)];
        part.Low = part.Low.cwiseMin(point);
        part.High = part.High.cwiseMax(point);
        if (mesh.Opposite[h] < 0)
        {
          part.BorderLength += (mesh.Points[mesh.To(h)] - point).norm();
        }
      }
    }
    // By area; by place where two have the same.
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
      [&](int a, int b)
      {
        const Part& p = parts[a];
        const Part& q = parts[b];
        return p.Area != q.Area ? p.Area > q.Area
                                : std::lexicographical_compare(p.Moment.data(), p.Moment.data() + 3,
                                    q.Moment.data(), q.Moment.data() + 3);
      });
    std::vector<int> rank(count);
    for (int i = 0; i < count; ++i)
    {
      rank[order[i]] = i;
      this->Parts.push_back(std::move(parts[order[i]]));
    }
    this->PartOfTriangle = std::move(component);
    for (int& part : this->PartOfTriangle)
    {
      part = rank[part];
    }
  }

  std::vector<Part> Parts;
  std::vector<int> PartOfTriangle;

  double GetNearness() const { return this->Nearness; }

  /// Of the smaller to the larger one.
  Relation RelationTo(Part& large, Part& small)
  {
    Contact contact;
    if (this->FindContact(large, small, contact) || this->FindContact(small, large, contact))
    {
      return Relation::Touching;
    }
    const Eigen::Vector3d& inSmall =
      this->Mesh.Points[this->Mesh.Triangles[small.Triangles.front()][0]];
    return this->BoxHolds(large, inSmall) && this->TreeOf(large).WindingNumber(inSmall) > 0.5
      ? Relation::Inside
      : Relation::Apart;
  }

private:
  const TriangleTree& TreeOf(Part& part)
  {
    if (!part.Tree)
    {
      part.Tree = std::make_unique<TriangleTree>(this->Mesh, part.Triangles);
    }
    return *part.Tree;
  }

  /// Where samples of one part lie near the other.
  struct Contact
  {
    Eigen::Vector3d Low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d High = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  };

  bool BoxHolds(const Part& part, const Eigen::Vector3d& point) const
  {
    return (point.array() >= part.Low.array()).all() && (point.array() <= part.High.array()).all();
  }

  /// Whether edges of `part` cross the other, or enough of its corners and middles of edges and of
  /// triangles lie near it: parts that meet in a point only do not belong together.
  bool FindContact(Part& other, const Part& part, Contact& contact)
  {
    for (int t : part.Triangles)
    {
      const auto& c = this->Mesh.Triangles[t];
      const Eigen::Vector3d* p[3] = { &this->Mesh.Points[c[0]], &this->Mesh.Points[c[1]],
        &this->Mesh.Points[c[2]] };
      const Eigen::Vector3d low = p[0]->cwiseMin(*p[1]).cwiseMin(*p[2]);
      const Eigen::Vector3d high = p[0]->cwiseMax(*p[1]).cwiseMax(*p[2]);
      if ((low.array() > other.High.array() + this->Nearness).any() ||
        (high.array() < other.Low.array() - this->Nearness).any())
      {
        continue;
      }
      bool touching = this->Extend(contact, other, (*p[0] + *p[1] + *p[2]) / 3.0);
      for (int k = 0; k < 3 && !touching; ++k)
      {
        const Eigen::Vector3d& a = *p[k];
        const Eigen::Vector3d& b = *p[(k + 1) % 3];
        touching = this->Extend(contact, other, a) || this->Extend(contact, other, 0.5 * (a + b)) ||
          this->TreeOf(other).IsCrossedBy(a, b);
      }
      if (touching)
      {
        return true;
      }
    }
    return false;
  }

  /// Takes a point into the contact if it lies near the part; true once that is more than a point.
  bool Extend(Contact& contact, Part& part, const Eigen::Vector3d& point)
  {
    if (this->TreeOf(part).Nearest(point, this->Nearness).Triangle < 0)
    {
      return false;
    }
    contact.Low = contact.Low.cwiseMin(point);
    contact.High = contact.High.cwiseMax(point);
    return (contact.High - contact.Low).norm() > this->Resolution;
  }

  const TriangleMesh& Mesh;
  double Resolution;
  double Nearness;
};
}

bool RelateParts(const TriangleMesh& mesh, double leastShare, double resolution,
  const Progress& progress, PartRelations& relations)
{
  Relating relating(mesh, resolution);
  const double nearness = relating.GetNearness();
  std::vector<Part>& parts = relating.Parts;
  const int count = static_cast<int>(parts.size());
  relations.NumberOfParts = count;
  relations.PartOfTriangle = relating.PartOfTriangle;
  relations.IsLeftOut.assign(count, 0);
  relations.Group.resize(count);
  std::iota(relations.Group.begin(), relations.Group.end(), 0);

  double area = 0.0;
  double crumbArea = 0.0;
  double borderLength = 0.0;
  int bodies = 0;
  for (const Part& part : parts)
  {
    area += part.Area;
    borderLength += part.BorderLength;
    if (part.Area < leastShare * parts.front().Area)
    {
      crumbArea += part.Area;
    }
    else
    {
      ++bodies;
    }
  }
  relations.IsShreds = crumbArea > 0.5 * area || borderLength * resolution > 0.25 * area;
  if (relations.IsShreds)
  {
    return true;
  }
  std::fill(relations.IsLeftOut.begin() + bodies, relations.IsLeftOut.end(), 1);

  // Boxes along x, so that only those that overlap there are compared.
  std::vector<int> order(bodies);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    { return parts[a].Low[0] != parts[b].Low[0] ? parts[a].Low[0] < parts[b].Low[0] : a < b; });
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < bodies; ++i)
  {
    for (int j = i + 1; j < bodies && parts[order[j]].Low[0] <= parts[order[i]].High[0] + nearness;
         ++j)
    {
      if (parts[order[i]].Overlaps(parts[order[j]], nearness))
      {
        pairs.push_back(std::minmax({ order[i], order[j] }));
      }
    }
    if (static_cast<int>(pairs.size()) > mesh.NumberOfTriangles())
    {
      relations.IsShreds = true;
      std::fill(relations.IsLeftOut.begin(), relations.IsLeftOut.end(), 0);
      return true;
    }
  }
  std::sort(pairs.begin(), pairs.end());
  auto find = [&](int part)
  {
    while (relations.Group[part] != part)
    {
      part = relations.Group[part];
    }
    return part;
  };
  std::vector<std::pair<int, int>> inside;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto [large, small] = pairs[i];
    if (!Report(progress, static_cast<double>(i) / pairs.size()))
    {
      return false;
    }
    if (find(large) == find(small))
    {
      continue;
    }
    const Relation relation = relating.RelationTo(parts[large], parts[small]);
    if (relation == Relation::Touching)
    {
      const auto [low, high] = std::minmax({ find(large), find(small) });
      relations.Group[high] = low;
    }
    else if (relation == Relation::Inside)
    {
      inside.push_back({ large, small });
    }
  }
  for (int part = 0; part < count; ++part)
  {
    relations.Group[part] = find(part);
  }
  // Inside a part of another group: all of the group is, as none of it crosses that part.
  std::vector<char> groupIsInside(count, 0);
  for (const auto& [large, small] : inside)
  {
    if (relations.Group[large] != relations.Group[small])
    {
      groupIsInside[relations.Group[small]] = 1;
    }
  }
  // Open parts may lie inside one another: the largest stays.
  groupIsInside[relations.Group[0]] = 0;
  for (int part = 0; part < bodies; ++part)
  {
    relations.IsLeftOut[part] |= groupIsInside[relations.Group[part]];
  }
  return true;
}
}
