// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Display_h
#define marrow_Display_h

namespace marrow
{
/// Whether DISPLAY names an X display that answers. Where pictures need none, always true.
bool CanOpenDisplay();
}

#endif
