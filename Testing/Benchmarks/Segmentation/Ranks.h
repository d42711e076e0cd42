// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Ranks_h
#define marrow_Ranks_h

#include <vtkSmartPointer.h>

#include <string>

class vtkMultiProcessController;
class vtkPolyData;

namespace marrow::bench
{
/// The processes that mpiexec started, through VTK's MPI controller; one alone where the program was
/// started without it or built without VTK::ParallelMPI. All ranks must call the functions alike.
class Ranks
{
public:
  Ranks(int* argc, char*** argv);
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int Rank() const;
  int Size() const;
  bool IsFirst() const { return this->Rank() == 0; }

  /// Gives every rank what `root` has; `data` must not be null anywhere.
  void Broadcast(vtkPolyData* data, int root);
  void Broadcast(double* values, int size, int root);
  void Broadcast(std::string& text, int root);
  void Barrier();

private:
  vtkSmartPointer<vtkMultiProcessController> Controller;
};
}

#endif
