// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_RenderCommand_h
#define marrow_RenderCommand_h

#include "Command.h"

#include <string>
#include <vector>

/// `marrow render`: meshes side by side in one picture (vtkMarrowSideBySideScene).
class RenderCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& marrow) override;
  void Run(Console& console) override;

private:
  std::vector<std::string> Meshes;
  std::vector<std::string> Skeletons;
  std::vector<std::string> Captions;
  std::vector<std::string> Measures;
  std::string Segments;
  std::string Output;
  std::vector<double> ViewUp = { 0.0, 1.0, 0.0 };
  std::vector<double> ViewDirection = { 0.0, 0.0, 0.0 };
  std::vector<int> TileSize = { 400, 400 };
  double Azimuth = 25.0;
  double Elevation = 12.0;
  double Opacity = -1.0;
  int Columns = 0;
  bool DoNotAlign = false;
  bool ShowMatches = false;
};

#endif
