// SPDX-License-Identifier: BSD-3-Clause
// Draws the pictures of the documentation:
//   marrow-figures OUTPUT_FOLDER MESH_FOLDER [NAME...]
#include "Figures.h"

#include <vtkPNGWriter.h>

#include <iostream>
#include <set>
#include <stdexcept>

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: marrow-figures OUTPUT_FOLDER MESH_FOLDER [NAME...]\n";
    return 2;
  }
  std::set<std::string> wanted(argv + 3, argv + argc);
  const bool all = wanted.empty();
  int failures = 0;
  for (const figures::Drawings& drawings : { figures::MeasureFigures(), figures::SkeletonFigures(),
         figures::CorrespondenceFigures(), figures::LoopFigures(), figures::GhostFigures(),
         figures::RegionFigures(), figures::SnakeFigures(), figures::TransferFigures(),
         figures::LimitationFigures(), figures::ReferenceFigures() })
  {
    for (const auto& [name, draw] : drawings)
    {
      if (!all && wanted.erase(name) == 0)
      {
        continue;
      }
      const std::string file = std::string(argv[1]) + "/" + name + ".png";
      try
      {
        vtkNew<vtkPNGWriter> writer;
        writer->SetInputData(draw(argv[2]));
        writer->SetFileName(file.c_str());
        writer->SetCompressionLevel(9);
        writer->Write();
        std::cout << file << std::endl;
      }
      catch (const std::exception& error)
      {
        std::cerr << file << ": " << error.what() << std::endl;
        ++failures;
      }
    }
  }
  for (const std::string& name : wanted)
  {
    std::cerr << "There is no picture " << name << "\n";
    ++failures;
  }
  return failures == 0 ? 0 : 1;
}
