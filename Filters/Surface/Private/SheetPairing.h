// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SheetPairing_h
#define marrow_SheetPairing_h

#include "TriangleMesh.h"

namespace marrow
{
/// Fills Opposite so that every half-edge has at most one partner, whatever their directions: the
/// two of an ordinary edge are partners; at an edge of more triangles those that bound the same
/// wedge of solid, where as many run one way as the other (bodies that touch along an edge stay
/// closed), else the pairs that come nearest to a plane (a fin is left with a border). Returns how
/// many edges had more than two triangles.
int PairSheets(TriangleMesh& mesh);
}

#endif
