// SPDX-License-Identifier: BSD-3-Clause
#include "MutatedMeshes.h"

using namespace marrow;
using namespace marrow::test;

/// Whatever is done to a mesh, it gives a sound working surface.
TEST(RandomMeshes, AllBecomeSound)
{
  const MutatedMeshSeeds seeds(300);
  int refused = 0;
  for (int seed = seeds.First; seed < seeds.End; ++seed)
  {
    std::string what;
    const PolygonMesh mesh = MakeMutatedMesh(seed, what);
    SCOPED_TRACE(what);
    WorkingSurface surface;
    WorkingSurfaceParameters parameters;
    parameters.MaximumFaces = 500;
    const std::string error = ComputeWorkingSurface(mesh, parameters, {}, surface);
    EXPECT_EQ(error.find("not finite") != std::string::npos, HasNaN(mesh)) << error;
    if (error.empty())
    {
      ExpectSound(mesh, surface);
    }
    else if (!HasNaN(mesh))
    {
      // A tiny mesh with something huge on it: next to that it has no area.
      EXPECT_EQ(error, "None of the mesh's faces has an area: connect a surface.");
      ++refused;
    }
    if (HasFailure())
    {
      return;
    }
  }
  EXPECT_LE(refused, (seeds.End - seeds.First) / 100);
}
