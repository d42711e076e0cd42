// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_HintBridge_h
#define marrow_HintBridge_h

#include "Hints.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace marrow
{
/// Reads two point sets whose points of equal number are one hint each; either may be null. A point of the
/// source whose value of the array Forbidden is not 0 must not correspond to its partner. Returns one
/// sentence that says what is wrong, or an empty one.
std::string ReadHints(vtkPointSet* source, vtkPointSet* target, std::vector<PointHint>& hints);
}

#endif
