// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CommandError_h
#define marrow_CommandError_h

#include <stdexcept>
#include <string>

/// What ends the program: one sentence for the user that says what is wrong, where, and the remedy.
class CommandError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

#endif
