// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_HoleFilling_h
#define marrow_HoleFilling_h

#include "MendedMesh.h"

namespace marrow
{
/// Closes the holes that are small against the part around them, and leaves the openings of tubes (a
/// neck, a sleeve, a bowl) open. The collar tells: the area of the surface nearer to the hole than a
/// diameter of it, r = P/π with P its perimeter. Round a hole in a plane that is P r + π r² = 2 P r,
/// around the end of a tube P r; a hole with a collar of more than half way between is closed, by the
/// diagonals of its border. Needs an oriented manifold and leaves one. Returns how many were closed.
int FillHoles(MendedMesh& mesh);
}

#endif
