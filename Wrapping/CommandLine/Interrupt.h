// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Interrupt_h
#define marrow_Interrupt_h

class vtkAlgorithm;

/// While it lives, Ctrl-C stops a filter at its next step of progress in place of ending the program. A
/// second Ctrl-C ends it.
class Interrupt
{
public:
  explicit Interrupt(vtkAlgorithm* algorithm);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool IsAsked() const;

private:
  vtkAlgorithm* Algorithm;
  unsigned long Observer;
  void (*Before)(int);
};

#endif
