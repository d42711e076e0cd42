// SPDX-License-Identifier: BSD-3-Clause
#include "SliceWalker.h"

#include <cstddef>

namespace marrow
{
Slice SliceWalker::Walk(
  int vertex, const Eigen::Vector3d& planeNormal, const SliceBounds& bounds) const
{
  const int rank = this->Mesh.RankOfVertex[vertex];
  if (rank < 0)
  {
    return Slice();
  }
  SliceTracer tracer(this->Mesh);
  tracer.Begin(rank, planeNormal, bounds);
  while (tracer.NextCurve())
  {
    this->Follow(tracer.Curve);
  }
  return tracer.Result();
}

void SliceWalker::Follow(SliceCurve& curve) const
{
  // The step limit guards against a mesh that is not what it claims to be.
  for (std::size_t step = 0; curve.HalfEdge >= 0 && !curve.Path.Abandoned; ++step)
  {
    const SliceMesh::HalfEdge& halfEdge = this->Mesh.HalfEdges[curve.HalfEdge];
    if (halfEdge.Apex == curve.Vertex)
    {
      curve.Path.LineTo(curve.Origin);
      curve.Path.Closed = true;
      return;
    }
    const Eigen::Vector3d& apex = this->Mesh.Points[halfEdge.Apex];
    const double apexDistance = curve.SignedDistance(apex);
    const bool sideOfStart = (apexDistance >= 0.0) == (curve.StartDistance >= 0.0);
    (sideOfStart ? curve.Start : curve.End) = apex;
    (sideOfStart ? curve.StartDistance : curve.EndDistance) = apexDistance;
    curve.HalfEdge = halfEdge.Onward[sideOfStart];
    curve.CrossEdge();
    curve.Path.Abandoned = curve.LeastLength() > curve.Bound || step > this->Mesh.HalfEdges.size();
  }
}
}
