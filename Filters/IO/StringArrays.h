// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_StringArrays_h
#define marrow_StringArrays_h

#include <string>
#include <vector>

class vtkFieldData;

namespace marrow
{
/// Sets an array of strings, replacing one of that name; no strings remove it.
void SetStrings(vtkFieldData* data, const char* name, const std::vector<std::string>& strings);

/// The strings of that name; none if there is no such array.
std::vector<std::string> GetStrings(vtkFieldData* data, const char* name);
}

#endif
