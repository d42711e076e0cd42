// SPDX-License-Identifier: BSD-3-Clause
// marrow-matching-accuracy: how good matching is by given weights (MatchingWeights), in seconds where the
// benchmark takes minutes; what fit_weights.py asks again and again.
//
//   marrow-matching-accuracy DATA [--meshes N] [--category NAME...]
//
// Prints the names of the weights and of the categories, a line each, and the weights as they are. Then, for each
// line of numbers on the standard input, weights in this order, a line with the label accuracy of each category: of
// all ordered pairs, of what the chosen answer carries coarsely.
#include "BenchmarkData.h"
#include "ParallelJobs.h"

#include "AnalyzedSide.h"
#include "AnswerChoice.h"
#include "AnswerSearch.h"
#include "CollectionShape.h"
#include "DenseMap.h"
#include "OtherAnswers.h"
#include "SkeletonMatching.h"

#include <vtkMarrowMeshReader.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace marrow;
using namespace marrow::bench;

namespace
{
using Weight = std::pair<const char*, double MatchingWeights::*>;
const std::vector<Weight> Weights = {
  { "Length", &MatchingWeights::Length },
  { "LengthTolerance", &MatchingWeights::LengthTolerance },
  { "Profile", &MatchingWeights::Profile },
  { "Chord", &MatchingWeights::Chord },
  { "Angle", &MatchingWeights::Angle },
  { "Twin", &MatchingWeights::Twin },
  { "Centricity", &MatchingWeights::Centricity },
  { "Taper", &MatchingWeights::Taper },
  { "Saturation", &MatchingWeights::Saturation },
  { "Unmatched", &MatchingWeights::Unmatched },
  { "Split", &MatchingWeights::Split },
  { "Pose", &MatchingWeights::Pose },
  { "Handedness", &MatchingWeights::Handedness },
  { "Surface", &MatchingWeights::Surface },
  { "Coverage", &MatchingWeights::Coverage },
};

struct Shape
{
  AnalyzedSide Side;
  std::unique_ptr<CollectionShape> Body; ///< the first of the side
  std::vector<int> LabelOfSample;        ///< per coarse vertex
};

std::unique_ptr<Shape> ReadShape(const std::string& folder, int id)
{
  auto shape = std::make_unique<Shape>();
  vtkNew<vtkMarrowMeshReader> reader;
  reader->SetFileName(MeshFile(folder, id).c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  const std::string error = AnalyzeSide(mesh, nullptr, shape->Side, {});
  if (!error.empty())
  {
    throw std::runtime_error(MeshFile(folder, id) + ": " + error);
  }
  const std::vector<int> labels = LabelsOfBody(shape->Side.Surface,
    shape->Side.Surface.Bodies.front(), ReadLabels(folder, id, mesh->GetNumberOfCells()));
  const TriangleMesh& fine = shape->Side.Bodies.front().Mesh;
  shape->Body = std::make_unique<CollectionShape>(shape->Side.Bodies.front());
  // Coarse vertices are vertices of the fine mesh.
  const auto key = [](const Eigen::Vector3d& p) {
    return std::array<double, 3>{ p.x(), p.y(), p.z() };
  };
  std::map<std::array<double, 3>, int> labelAt;
  for (int t = 0; t < fine.NumberOfTriangles(); ++t)
  {
    for (const int corner : fine.Triangles[t])
    {
      labelAt.emplace(key(fine.Points[corner]), labels[t]);
    }
  }
  for (const Eigen::Vector3d& point : shape->Body->Coarse.Side.Mesh.Points)
  {
    shape->LabelOfSample.push_back(labelAt.at(key(point)));
  }
  return shape;
}

double AccuracyOf(const Shape& source, const Shape& target, const AnswerTrial& trial)
{
  double right = 0.0;
  double all = 0.0;
  for (std::size_t v = 0; v < target.LabelOfSample.size(); ++v)
  {
    for (const int corner : source.Body->Coarse.Side.Mesh.Triangles[trial.FoundTriangles[v]])
    {
      const double share = target.Body->Coarse.Shares[v];
      right += source.LabelOfSample[corner] == target.LabelOfSample[v] ? share : 0.0;
      all += share;
    }
  }
  return right / all;
}

/// As RankAnswers, but nothing that does not depend on the weights is computed anew.
double MeasurePair(const Shape& source, const Shape& target, const MatchingWeights& weights)
{
  const CollectionShape& from = *source.Body;
  const CollectionShape& to = *target.Body;
  MatchingParameters parameters;
  parameters.Weights = weights;
  std::vector<Answer> answers = FindAnswersBy(from.Fine.Skeleton, to.Fine.Skeleton, parameters, {});
  PreferSlices(from.Fine, to.Fine, answers);
  AddWhole(from.Fine, to.Fine, answers);
  DenseMapper there(
    from.Coarse.Side, to.Coarse.Side, from.GetCoarseSearch(), to.GetCoarseSmoother());
  DenseMapper back(
    to.Coarse.Side, from.Coarse.Side, to.GetCoarseSearch(), from.GetCoarseSmoother());
  std::vector<double> against;
  std::vector<double> accuracies;
  for (const Answer& answer : answers)
  {
    const AnswerTrial ofThere = TryAnswer(from.Coarse, to.Coarse, there, answer);
    const AnswerTrial ofBack = TryAnswer(to.Coarse, from.Coarse, back, Turned(answer));
    against.push_back(0.5 * (ofThere.Against.Sum() + ofBack.Against.Sum()));
    accuracies.push_back(AccuracyOf(source, target, ofThere));
  }
  return accuracies[RankAnswers(against).front()];
}

struct Collection
{
  std::string Name;
  std::vector<std::unique_ptr<Shape>> Shapes;
};

std::vector<double> Measure(
  const std::vector<Collection>& collections, const MatchingWeights& weights, int threads)
{
  struct Job
  {
    std::size_t Collection, Source, Target;
    double Accuracy;
  };
  std::vector<Job> jobs;
  for (std::size_t c = 0; c < collections.size(); ++c)
  {
    const std::size_t size = collections[c].Shapes.size();
    for (std::size_t i = 0; i < size * size; ++i)
    {
      if (i / size != i % size)
      {
        jobs.push_back({ c, i / size, i % size, 0.0 });
      }
    }
  }
  RunJobs(static_cast<int>(jobs.size()), threads,
    [&](int i)
    {
      Job& job = jobs[i];
      const auto& shapes = collections[job.Collection].Shapes;
      job.Accuracy = MeasurePair(*shapes[job.Source], *shapes[job.Target], weights);
    });
  std::vector<double> sums(collections.size(), 0.0);
  std::vector<int> counts(collections.size(), 0);
  for (const Job& job : jobs)
  {
    sums[job.Collection] += job.Accuracy;
    ++counts[job.Collection];
  }
  for (std::size_t c = 0; c < sums.size(); ++c)
  {
    sums[c] /= std::max(counts[c], 1);
  }
  return sums;
}

template <typename Values, typename Text>
void PrintLine(const Values& values, Text&& text)
{
  const char* separator = "";
  for (const auto& value : values)
  {
    std::cout << separator << text(value);
    separator = " ";
  }
  std::cout << std::endl;
}

void Serve(const std::vector<Collection>& collections, int threads)
{
  const MatchingWeights defaults;
  PrintLine(Weights, [](const Weight& weight) { return weight.first; });
  PrintLine(collections, [](const Collection& collection) { return collection.Name; });
  PrintLine(Weights, [&](const Weight& weight) { return defaults.*weight.second; });
  for (std::string line; std::getline(std::cin, line);)
  {
    MatchingWeights weights;
    std::istringstream numbers(line);
    for (const auto& [name, member] : Weights)
    {
      if (!(numbers >> weights.*member))
      {
        throw std::runtime_error(std::string("The line has no number for ") + name + ".");
      }
    }
    PrintLine(Measure(collections, weights, threads), [](double accuracy) { return accuracy; });
  }
}
}

int main(int argc, char** argv)
{
  CLI::App app("Label accuracy of the matching by the weights on each line of the standard input");
  std::string folder;
  std::vector<std::string> categories;
  std::size_t meshes = std::string::npos;
  int threads = std::max(1u, std::thread::hardware_concurrency());
  app.add_option("data", folder, "Folder of the benchmark's files")->required();
  app.add_option("--category", categories, "Only these");
  app.add_option("--meshes", meshes, "Only so many of each category, the last ones");
  app.add_option("--threads", threads, "Default: all processors")->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);
  try
  {
    std::vector<Collection> collections;
    for (const Category& category : ReadIndex(folder))
    {
      if (!categories.empty() &&
        std::find(categories.begin(), categories.end(), category.Name) == categories.end())
      {
        continue;
      }
      collections.push_back({ category.Name, {} });
      const std::size_t size = category.Meshes.size();
      for (std::size_t i = size - std::min(meshes, size); i < size; ++i)
      {
        collections.back().Shapes.push_back(ReadShape(folder, category.Meshes[i]));
      }
    }
    Serve(collections, threads);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
