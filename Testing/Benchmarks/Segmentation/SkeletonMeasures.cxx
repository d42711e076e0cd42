// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonMeasures.h"

#include "MeshCheck.h"
#include "WindingNumber.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>

namespace marrow::bench
{
namespace
{
void MeasureTerminals(const PreparedMesh& mesh, const std::vector<std::string>& labelNames,
  const Extremities& extremities, Result& result)
{
  const auto nameOf = [&](int piece)
  {
    const auto label = mesh.LabelOfPiece.find(piece);
    return label == mesh.LabelOfPiece.end() ? std::string() : labelNames.at(label->second);
  };
  std::map<int, int> terminalsOfPiece;
  double judged = 0.0;
  for (int node = 0; node < mesh.PlainSkeleton.NumberOfNodes(); ++node)
  {
    if (mesh.PlainSkeleton.TypeOf(node) == NodeType::Terminal)
    {
      const int piece = MajorityOfNodes(mesh, { node }, mesh.Pieces);
      const std::string name = nameOf(piece);
      judged += extremities.Natural.count(name) == 0;
      ++terminalsOfPiece[piece];
    }
  }
  double pieces = 0.0;
  double found = 0.0;
  for (const auto& [piece, label] : mesh.LabelOfPiece)
  {
    if (extremities.Labels.count(labelNames.at(label)) > 0)
    {
      pieces += 1.0;
      found += terminalsOfPiece.count(piece) > 0;
    }
  }
  result.Values["extremities"] = pieces;
  result.Values["found_extremities"] = found;
  result.Values["judged_terminals"] = judged;
  result.Values["right_terminals"] = found;
}

int CountSpurs(const marrow::Skeleton& skeleton)
{
  int spurs = 0;
  for (const Branch& branch : skeleton.Branches)
  {
    for (const auto& [end, other] :
      { std::pair(branch.Front(), branch.Back()), std::pair(branch.Back(), branch.Front()) })
    {
      spurs += skeleton.TypeOf(end) == NodeType::Terminal &&
        skeleton.TypeOf(other) == NodeType::Junction &&
        branch.Length() < skeleton.Graph[other].Radius;
    }
  }
  return spurs;
}
}

const std::vector<std::string>& MeshColumns()
{
  static const std::vector<std::string> columns = { "faces", "genus", "loops", "nodes",
    "nodes_inside", "terminals", "spurs", "extremities", "found_extremities", "judged_terminals",
    "right_terminals", "seconds_field", "seconds_skeleton" };
  return columns;
}

Result MeasureSkeleton(const PreparedMesh& mesh, const std::vector<std::string>& labelNames,
  const Extremities& extremities)
{
  Result result;
  result.Source = result.Target = mesh.Id;
  result.Error = mesh.Error;
  if (!result.Error.empty())
  {
    return result;
  }
  const marrow::Skeleton& skeleton = mesh.PlainSkeleton;
  double inside = 0.0;
  double terminals = 0.0;
  for (int node = 0; node < skeleton.NumberOfNodes(); ++node)
  {
    inside += std::abs(WindingNumber(mesh.Mesh, skeleton.Graph[node].Position)) > 0.5;
    terminals += skeleton.TypeOf(node) == NodeType::Terminal;
  }
  result.Values["faces"] = mesh.Mesh.NumberOfTriangles();
  result.Values["genus"] = CheckMesh(mesh.Mesh).Genus();
  result.Values["loops"] = skeleton.NumberOfLoops();
  result.Values["nodes"] = skeleton.NumberOfNodes();
  result.Values["nodes_inside"] = inside;
  result.Values["terminals"] = terminals;
  result.Values["spurs"] = CountSpurs(skeleton);
  result.Values["seconds_field"] = mesh.SecondsForField;
  result.Values["seconds_skeleton"] = mesh.SecondsForSkeleton;
  if (!extremities.Labels.empty())
  {
    MeasureTerminals(mesh, labelNames, extremities, result);
  }
  return result;
}
}
