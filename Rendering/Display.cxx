// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#ifdef MARROW_USE_X11
#include <X11/Xlib.h>
#endif

namespace marrow
{
bool CanOpenDisplay()
{
#ifdef MARROW_USE_X11
  Display* display = XOpenDisplay(nullptr);
  if (!display)
  {
    return false;
  }
  XCloseDisplay(display);
#endif
  return true;
}
}
