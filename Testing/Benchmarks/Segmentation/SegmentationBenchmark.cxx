// SPDX-License-Identifier: BSD-3-Clause
// marrow-benchmark-segmentation: every mesh of a labelled collection as the source, every other mesh
// of its category as the target; see README.md beside this file.
#include "BenchmarkRun.h"
#include "Ranks.h"
#include "Summary.h"

#include <vtkFileOutputWindow.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <thread>

using namespace marrow::bench;

namespace
{
/// What VTK reports of filters inside of filters goes to a file, not between the progress bar.
void RedirectMessages(const std::string& resultFolder)
{
  std::filesystem::create_directories(resultFolder);
  vtkNew<vtkFileOutputWindow> window;
  window->SetFileName((resultFolder + "/messages.txt").c_str());
  window->AppendOn();
  vtkOutputWindow::SetInstance(window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

void WriteSummaries(
  const BenchmarkRun& run, const BenchmarkOptions& options, const ReferenceFigures& figures)
{
  const std::vector<Result> meshes = run.Meshes();
  std::vector<std::string> names;
  for (const Category& category : ReadIndex(options.DataFolder))
  {
    if (std::any_of(meshes.begin(), meshes.end(),
          [&](const Result& mesh) { return mesh.Category == category.Name; }))
    {
      names.push_back(category.Name);
    }
  }
  const std::vector<SummaryRow> summary = Summarize(names, run.Pairs(), meshes, figures);
  WriteSummary(summary, options.Method, options.ResultFolder + "/summary.csv");
  std::cout << options.Method.Name() << "\n";
  PrintSummary(summary, std::cout);
}
}

int main(int argc, char** argv)
{
  Ranks processes(&argc, &argv);
  const int processors = std::max(1u, std::thread::hardware_concurrency());
  BenchmarkOptions options;
  options.Jobs = std::max(1, processors / processes.Size());

  CLI::App app{ "Measures segmentation transfer on a labelled collection of meshes" };
  app.name("marrow-benchmark-segmentation");
  app.add_option("data", options.DataFolder, "Folder with index.json, meshes, labels, ...")
    ->required();
  app
    .add_option(
      "-o,--output", options.ResultFolder, "Folder for the results; what it holds is kept")
    ->required();
  app.add_option("--category", options.Categories, "Only these categories");
  const std::map<std::string, SkeletonKind> skeletons = { { "msp", SkeletonKind::MSP },
    { "curvature", SkeletonKind::MeanCurvature } };
  app
    .add_option("--skeleton", options.Method.Skeleton, "msp (default), or the baseline: curvature")
    ->transform(CLI::CheckedTransformer(skeletons))
    ->check(
      [](const std::string& kind)
      {
        return kind == std::to_string(static_cast<int>(SkeletonKind::MeanCurvature)) &&
            !HasMeanCurvatureSkeleton()
          ? "this program was built without CGAL"
          : "";
      });
  const std::map<std::string, MatcherKind> matchers = { { "tree", MatcherKind::Tree },
    { "electors", MatcherKind::Electors } };
  app
    .add_option(
      "--matcher", options.Method.Matcher, "tree (default), or the baseline: electors (voting)")
    ->transform(CLI::CheckedTransformer(matchers));
  const std::map<std::string, LastStage> stages = { { "skeleton", LastStage::Skeleton },
    { "correspondence", LastStage::Correspondence }, { "transfer", LastStage::Transfer } };
  app
    .add_option("--until", options.Method.Until,
      "The last stage to measure: skeleton, correspondence or transfer (default)")
    ->transform(CLI::CheckedTransformer(stages));
  app.add_option("--meshes", options.MeshesPerCategory, "Only the first so many of a category")
    ->check(CLI::Range(2, 1000));
  app.add_option("-j,--jobs", options.Jobs, "Pairs at once in this process")
    ->check(CLI::Range(1, 1024))
    ->capture_default_str();
  app.add_flag("-q,--quiet", options.Quiet, "No progress bar");
  CLI11_PARSE(app, argc, argv);

  vtkSMPTools::Initialize(std::max(1, processors / processes.Size() / options.Jobs));
  RedirectMessages(options.ResultFolder);
  try
  {
    const ReferenceFigures figures = ReadReferenceFigures(MARROW_BENCHMARK_FIGURES);
    BenchmarkRun run(options, figures, processes);
    run.Measure();
    if (processes.IsFirst())
    {
      WriteSummaries(run, options, figures);
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "marrow-benchmark-segmentation: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
