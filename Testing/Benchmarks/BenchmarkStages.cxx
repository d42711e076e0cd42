// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMesh.h"

#include <vtkCreatureSource.h>
#include <vtkMSPField.h>
#include <vtkMSPSkeleton.h>
#include <vtkNew.h>
#include <vtkSegmentationTransfer.h>
#include <vtkSkeletonCorrespondence.h>

using namespace marrow;

namespace
{
/// A quadruped and what the stages before the measured one make of it.
struct Prepared
{
  Prepared(int faces, int seed, double variation)
  {
    vtkNew<vtkCreatureSource> creature;
    creature->SetResolution(faces);
    creature->SetSeed(seed);
    creature->SetPose(variation);
    creature->SetProportion(variation);
    creature->Update();
    this->Skeleton->SetInputData(creature->GetOutput());
    this->Skeleton->Update();
    this->Faces = static_cast<double>(creature->GetOutput()->GetNumberOfPolys());
  }

  vtkNew<vtkMSPSkeleton> Skeleton;
  double Faces = 0.0;
};

/// From a bare mesh to its skeleton: what the baseline does.
void MeasuresAndSkeleton(benchmark::State& state)
{
  const auto mesh = bench::Mesh(static_cast<int>(state.range(0)));
  vtkNew<vtkMSPSkeleton> filter;
  filter->SetInputData(mesh);
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["faces"] = static_cast<double>(mesh->GetNumberOfPolys());
}

/// From a mesh that has its measures to its skeleton.
void Skeleton(benchmark::State& state)
{
  vtkNew<vtkMSPField> field;
  field->SetInputData(bench::Mesh(static_cast<int>(state.range(0))));
  field->Update();
  vtkNew<vtkMSPSkeleton> filter;
  filter->SetInputData(field->GetOutput());
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["faces"] = static_cast<double>(field->GetOutput()->GetNumberOfPolys());
}

/// Two skeletons to their correspondence.
void Correspondence(benchmark::State& state)
{
  const Prepared source(static_cast<int>(state.range(0)), 1, 0.0);
  const Prepared target(static_cast<int>(state.range(0)), 2, 0.5);
  vtkNew<vtkSkeletonCorrespondence> filter;
  filter->SetInputData(0, source.Skeleton->GetOutput(0));
  filter->SetInputData(1, target.Skeleton->GetOutput(0));
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["faces"] = source.Faces;
}

/// Segments from mesh to mesh, the skeletons and their correspondence given.
void Transfer(benchmark::State& state)
{
  const Prepared source(static_cast<int>(state.range(0)), 1, 0.0);
  const Prepared target(static_cast<int>(state.range(0)), 2, 0.5);
  vtkNew<vtkSkeletonCorrespondence> correspondence;
  correspondence->SetInputData(0, source.Skeleton->GetOutput(0));
  correspondence->SetInputData(1, target.Skeleton->GetOutput(0));
  correspondence->Update();
  vtkNew<vtkSegmentationTransfer> filter;
  filter->SetInputData(0, source.Skeleton->GetOutput(1));
  filter->SetInputData(1, target.Skeleton->GetOutput(1));
  filter->SetInputData(2, correspondence->GetOutput(0));
  filter->SetInputData(3, correspondence->GetOutput(1));
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["faces"] = source.Faces;
}
}

BENCHMARK(MeasuresAndSkeleton)->Apply(bench::Sizes)->Arg(200000);
BENCHMARK(Skeleton)->Apply(bench::Sizes);
BENCHMARK(Correspondence)->Apply(bench::Sizes);
BENCHMARK(Transfer)->Apply(bench::Sizes);
