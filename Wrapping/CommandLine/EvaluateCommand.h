// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_EvaluateCommand_h
#define marrow_EvaluateCommand_h

#include "Command.h"
#include "MeshFiles.h"

#include <string>
#include <vector>

class vtkPolyData;

/// `marrow evaluate`: how well segments agree with one or several references
/// (vtkMarrowSegmentationMetrics).
class EvaluateCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& marrow) override;
  void Run(Console& console) override;

private:
  /// The measures against one reference, or their mean.
  struct Row
  {
    std::string Reference;
    std::vector<double> Values; ///< in the order of Names
  };

  Row Compare(
    vtkPolyData* segmented, vtkPolyData* reference, const std::string& path, Console& console);
  Row Mean(const std::vector<Row>& rows) const;
  void PrintTable(const std::vector<Row>& rows) const;
  void PrintCsv(const std::vector<Row>& rows) const;
  void PrintJson(const std::vector<Row>& rows) const;

  std::string Mesh;
  files::SegmentSource Segments;
  std::vector<std::string> References;
  std::string ReferenceLabels = files::SegmentSource().Labels;
  bool Json = false;
  bool Csv = false;
  std::vector<std::string> Names; ///< of the measures
};

#endif
