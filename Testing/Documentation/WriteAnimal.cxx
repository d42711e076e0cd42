// SPDX-License-Identifier: BSD-3-Clause
// Writes a small quadruped and its segments:
//   WriteAnimal MESH.off SEGMENTS.seg
#include <vtkCreatureSource.h>
#include <vtkMarrowSegmentWriter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <fstream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    return 2;
  }
  vtkNew<vtkCreatureSource> creature;
  creature->SetShapeToQuadruped();
  creature->SetResolution(4000);
  creature->Update();
  vtkPolyData* mesh = creature->GetOutput();

  std::ofstream file(argv[1]);
  file << "OFF\n" << mesh->GetNumberOfPoints() << ' ' << mesh->GetNumberOfCells() << " 0\n";
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    file << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetCellPoints(i, size, corners);
    file << "3 " << corners[0] << ' ' << corners[1] << ' ' << corners[2] << '\n';
  }

  vtkNew<vtkMarrowSegmentWriter> segments;
  segments->SetInputConnection(creature->GetOutputPort());
  segments->SetFileName(argv[2]);
  return file.flush() && segments->Write() ? 0 : 1;
}
