// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FilterRun_h
#define marrow_FilterRun_h

#include <string>

class vtkAlgorithm;

namespace marrow::bench
{
/// Updates a filter and returns the seconds it took. Throws std::runtime_error with the first error;
/// counts the warnings in `numberOfWarnings` if that is not null.
double Run(vtkAlgorithm* filter, int* numberOfWarnings = nullptr);
}

#endif
