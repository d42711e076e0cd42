// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ImageComparison_h
#define marrow_ImageComparison_h

#include <vtkImageData.h>
#include <vtkImageDifference.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

namespace marrow::test
{
/// How much two pictures differ: vtkImageDifference without its leniency. By default it averages
/// and shifts until a ball moved by a tenth of its radius goes unseen; set so, that one gives some
/// 500.
inline double ImageError(vtkImageData* image, vtkImageData* expected)
{
  const int* size = image->GetDimensions();
  const int* expectedSize = expected->GetDimensions();
  if (size[0] != expectedSize[0] || size[1] != expectedSize[1])
  {
    return std::numeric_limits<double>::infinity();
  }
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(image);
  difference->SetImageData(expected);
  difference->SetThreshold(8);
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->Update();
  return difference->GetThresholdedError();
}

/// Compares with Testing/Data/Baseline/NAME.png. Where the error exceeds the threshold, or there is
/// no such picture yet, the test fails and leaves what was drawn in the build folder.
inline void ExpectImage(vtkImageData* image, const std::string& name, double threshold)
{
  const std::filesystem::path baseline =
    std::filesystem::path(MARROW_TEST_DATA) / "Baseline" / (name + ".png");
  const std::filesystem::path drawn = std::filesystem::path(MARROW_TEST_OUTPUT) / (name + ".png");
  double error = std::numeric_limits<double>::infinity();
  if (std::filesystem::exists(baseline))
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(baseline.c_str());
    reader->Update();
    error = ImageError(image, reader->GetOutput());
  }
  if (error > threshold)
  {
    std::filesystem::create_directories(drawn.parent_path());
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(drawn.c_str());
    writer->Write();
    ADD_FAILURE() << "The picture differs by " << error << " (allowed: " << threshold << ") from "
                  << baseline << "; it is in " << drawn
                  << ". If that one is right, copy it to the baselines.";
  }
}
}

#endif
