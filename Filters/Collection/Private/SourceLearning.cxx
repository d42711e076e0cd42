// SPDX-License-Identifier: BSD-3-Clause
#include "SourceLearning.h"

#include "AnswerVote.h"
#include "EdgePrices.h"
#include "LabelForest.h"
#include "LabelSpread.h"
#include "MeshSmoother.h"
#include "ParallelFor.h"
#include "SharedProgress.h"
#include "SurfaceFeatures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace marrow
{
namespace
{
/// For one forest, evenly over the area of all its meshes.
constexpr int NumberOfSamples = 2000;
/// A step of two apart accuracy hardly differs.
constexpr std::array<double, 5> Exponents{ 0.25, 0.5, 1.0, 2.0, 4.0 };
/// How much of the standard error of a gain is taken off it: gains of a few meshes may be luck.
constexpr double Caution = 0.5;
/// What a mesh may lose when its labels are held back.
constexpr double MostLoss = 0.005;
/// What the vote must reach on each of them: meshes that are told less are so unlike one another that what they
/// teach says nothing of further ones, whatever it gains on them.
constexpr double LeastByVote = 0.8;
/// Part of all shares that is evenly spread, so that no label is out of the question.
constexpr double EvenPart = 0.02;

/// A shape of a labelled mesh whose labels were held back.
struct HeldOutShape
{
  int Shape = -1;
  std::vector<double> Areas; ///< per vertex
  LabelShares Vote;          ///< per vertex
  std::vector<int> Columns;  ///< per vertex, of the right label
  Eigen::MatrixXf Features;  ///< per vertex, the vote among them
  std::unique_ptr<const MeshSmoother> Blend;
};
struct HeldOutMesh
{
  int Mesh = -1;
  double ByVote = 0.0; ///< accuracy
  std::vector<HeldOutShape> Shapes;
};

Eigen::MatrixXf FeaturesAndVote(const AnalyzedMesh& shape, const LabelShares& vote)
{
  const Eigen::MatrixXf features = SurfaceFeatures(shape);
  Eigen::MatrixXf all(features.rows(), features.cols() + vote.cols());
  all << features, vote;
  return all;
}

/// Per vertex the column of the label that has most area around it.
std::vector<int> ColumnsOfVertices(const TriangleMesh& mesh, const LabelShares& ofTriangles)
{
  LabelShares areas = LabelShares::Zero(mesh.NumberOfVertices(), ofTriangles.cols());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    for (const int corner : mesh.Triangles[t])
    {
      areas.row(corner) += static_cast<float>(mesh.Area(t)) * ofTriangles.row(t);
    }
  }
  std::vector<int> columns(mesh.Points.size(), 0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    areas.row(v).maxCoeff(&columns[v]);
  }
  return columns;
}

/// Fills all but the features and the accuracy. False if `progress` asked to stop.
bool HoldOut(const CollectionGraph& graph, int mesh, HeldOutMesh& heldOut, const Progress& progress)
{
  CollectionGraph without = graph.WithoutLabelsOf(mesh);
  if (!VoteOnAnswers(without, SubProgress(progress, 0.0, 0.2)))
  {
    return false;
  }
  ChooseTellers(without);
  if (!CarryMaps(without, SubProgress(progress, 0.2, 1.0)))
  {
    return false;
  }
  const std::vector<LabelShares> votes = SpreadShares(without);
  heldOut.Mesh = mesh;
  for (int s = 0; s < graph.NumberOfShapes(); ++s)
  {
    if (graph.MeshOf(s) == mesh)
    {
      const AnalyzedMesh& fine = graph.GetShape(s).Fine;
      heldOut.Shapes.push_back({ s, fine.Mesh.VertexAreas(), votes[s],
        ColumnsOfVertices(
          fine.Mesh, SharesOfLabels(graph.GetLabels(s), graph.GetDifferentLabels())),
        {}, std::make_unique<MeshSmoother>(fine.Mesh, BlendWidth * fine.Diagonal()) });
    }
  }
  return true;
}

/// The forest of all held out meshes but one; -1: of all.
LabelForest LearnFrom(const std::vector<HeldOutMesh>& meshes, int butMesh, int numberOfLabels)
{
  std::vector<std::pair<const HeldOutShape*, double>> shapes; // and its part of the area of all
  double numberOfMeshes = 0.0;
  for (const HeldOutMesh& mesh : meshes)
  {
    if (mesh.Mesh == butMesh)
    {
      continue;
    }
    ++numberOfMeshes;
    double area = 0.0;
    for (const HeldOutShape& shape : mesh.Shapes)
    {
      shapes.emplace_back(&shape, std::accumulate(shape.Areas.begin(), shape.Areas.end(), 0.0));
      area += shapes.back().second;
    }
    for (std::size_t i = shapes.size() - mesh.Shapes.size(); i < shapes.size(); ++i)
    {
      shapes[i].second /= area;
    }
  }
  std::vector<std::pair<const HeldOutShape*, int>> samples; // and the vertex
  for (const auto& [shape, part] : shapes)
  {
    const std::vector<double>& areas = shape->Areas;
    const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
    const int size = static_cast<int>(std::lround(NumberOfSamples * part / numberOfMeshes));
    double sum = 0.0;
    int taken = 0;
    for (std::size_t v = 0; v < areas.size(); ++v)
    {
      sum += areas[v];
      for (; taken < size && (taken + 0.5) * total < sum * size; ++taken)
      {
        samples.emplace_back(shape, static_cast<int>(v));
      }
    }
  }
  Eigen::MatrixXf features(
    static_cast<Eigen::Index>(samples.size()), meshes.front().Shapes.front().Features.cols());
  std::vector<int> columns;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const auto& [shape, vertex] = samples[i];
    features.row(static_cast<Eigen::Index>(i)) = shape->Features.row(vertex);
    columns.push_back(shape->Columns[vertex]);
  }
  return LabelForest(features, columns, numberOfLabels);
}

LabelShares Multiplied(const LabelShares& vote, const LabelShares& learnt, double exponent)
{
  const auto even = static_cast<float>(EvenPart / static_cast<double>(vote.cols()));
  LabelShares product =
    (vote.array() + even) * (learnt.array() + even).pow(static_cast<float>(exponent));
  SharpenShares(product, 1.0);
  return product;
}

/// The share of the area that gets the right label by shares of the vertices.
double AccuracyOf(const CollectionGraph& graph, const HeldOutMesh& mesh,
  const std::vector<LabelShares>& sharesOfShapes)
{
  double right = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < mesh.Shapes.size(); ++i)
  {
    const HeldOutShape& shape = mesh.Shapes[i];
    const TriangleMesh& surface = graph.GetShape(shape.Shape).Fine.Mesh;
    const std::vector<int>& labels = graph.GetLabels(shape.Shape);
    const LabelShares ofTriangles = SharesOfTriangles(
      surface, shape.Blend->Smooth(sharesOfShapes[i].cast<double>()).cast<float>());
    for (int t = 0; t < surface.NumberOfTriangles(); ++t)
    {
      Eigen::Index column = 0;
      ofTriangles.row(t).maxCoeff(&column);
      const double area = surface.Area(t);
      right += graph.GetDifferentLabels()[column] == labels[t] ? area : 0.0;
      total += area;
    }
  }
  return right / total;
}

/// Per exponent, 0 before all others.
std::vector<double> AccuraciesOf(
  const CollectionGraph& graph, const HeldOutMesh& mesh, const LabelForest& forest)
{
  std::vector<LabelShares> learnt;
  for (const HeldOutShape& shape : mesh.Shapes)
  {
    learnt.push_back(forest.Predict(shape.Features));
  }
  std::vector<double> accuracies{ mesh.ByVote };
  for (const double exponent : Exponents)
  {
    std::vector<LabelShares> products;
    for (std::size_t i = 0; i < mesh.Shapes.size(); ++i)
    {
      products.push_back(Multiplied(mesh.Shapes[i].Vote, learnt[i], exponent));
    }
    accuracies.push_back(AccuracyOf(graph, mesh, products));
  }
  return accuracies;
}

/// The place of the exponent among the accuracies; 0 if none gains.
std::size_t ChooseExponent(const std::vector<std::vector<double>>& accuracies)
{
  const auto size = static_cast<double>(accuracies.size());
  std::size_t best = 0;
  double most = 0.0;
  for (std::size_t e = 1; e <= Exponents.size(); ++e)
  {
    double mean = 0.0;
    bool isSafe = true;
    for (const std::vector<double>& of : accuracies)
    {
      isSafe = isSafe && of[e] >= of[0] - MostLoss;
      mean += (of[e] - of[0]) / size;
    }
    double squares = 0.0;
    for (const std::vector<double>& of : accuracies)
    {
      squares += std::pow(of[e] - of[0] - mean, 2);
    }
    const double cautious = mean - Caution * std::sqrt(squares / (size * (size - 1.0)));
    if (isSafe && cautious > most)
    {
      most = cautious;
      best = e;
    }
  }
  return best;
}
}

SourceLessons LearnFromSources(const CollectionGraph& graph,
  const std::vector<int>& meshesToHoldOut, std::vector<LabelShares>& ofVertices,
  const Progress& progress)
{
  SourceLessons lessons;
  if (meshesToHoldOut.empty())
  {
    return lessons;
  }
  const auto size = static_cast<double>(meshesToHoldOut.size());
  constexpr double afterVotes = 0.6;  // of the progress
  constexpr double afterTrials = 0.9; // likewise
  std::vector<HeldOutMesh> meshes(meshesToHoldOut.size());
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    const double begin = afterVotes * static_cast<double>(i) / size;
    if (!HoldOut(graph, meshesToHoldOut[i], meshes[i],
          SubProgress(progress, begin, begin + afterVotes / size)))
    {
      return lessons;
    }
  }
  ParallelFor(0, static_cast<int>(meshes.size()),
    [&](int first, int last)
    {
      for (int i = first; i < last; ++i)
      {
        std::vector<LabelShares> votes;
        for (HeldOutShape& shape : meshes[i].Shapes)
        {
          shape.Features = FeaturesAndVote(graph.GetShape(shape.Shape).Fine, shape.Vote);
          votes.push_back(shape.Vote);
        }
        meshes[i].ByVote = AccuracyOf(graph, meshes[i], votes);
      }
    });
  for (const HeldOutMesh& mesh : meshes)
  {
    lessons.HeldOut.push_back({ mesh.Mesh, mesh.ByVote, mesh.ByVote });
  }
  if (std::any_of(meshes.begin(), meshes.end(),
        [](const HeldOutMesh& mesh) { return mesh.ByVote < LeastByVote; }))
  {
    return lessons;
  }
  std::vector<std::vector<double>> accuracies;
  for (const HeldOutMesh& mesh : meshes)
  {
    accuracies.push_back(
      AccuraciesOf(graph, mesh, LearnFrom(meshes, mesh.Mesh, graph.NumberOfLabels())));
    const double done = static_cast<double>(accuracies.size()) / size;
    if (!Report(progress, afterVotes + (afterTrials - afterVotes) * done))
    {
      return lessons;
    }
  }
  const std::size_t best = ChooseExponent(accuracies);
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    lessons.HeldOut[i].Learnt = accuracies[i][best];
  }
  if (best == 0)
  {
    return lessons;
  }
  lessons.Exponent = Exponents[best - 1];
  const LabelForest forest = LearnFrom(meshes, -1, graph.NumberOfLabels());
  SharedProgress shared(SubProgress(progress, afterTrials, 1.0));
  ParallelFor(0, graph.NumberOfShapes(),
    [&](int first, int last)
    {
      for (int s = first; s < last; ++s)
      {
        if (!graph.IsSource(s))
        {
          ofVertices[s] = Multiplied(ofVertices[s],
            forest.Predict(FeaturesAndVote(graph.GetShape(s).Fine, ofVertices[s])),
            lessons.Exponent);
        }
        if (!shared.Add(1.0 / graph.NumberOfShapes()))
        {
          return;
        }
      }
    });
  return lessons;
}
}
