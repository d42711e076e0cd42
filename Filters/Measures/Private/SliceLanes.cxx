// SPDX-License-Identifier: BSD-3-Clause
#include "SliceLanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace marrow
{
namespace
{
constexpr int Count = SliceLaneCount;
// The bound costs a square root: look at it every so many steps.
constexpr int StepsPerBoundCheck = 6;

using Lane = std::array<double, Count>;
struct alignas(64) LanePoint
{
  Lane X;
  Lane Y;
  Lane Z;

  void Set(int lane, const Eigen::Vector3d& point)
  {
    this->X[lane] = point.x();
    this->Y[lane] = point.y();
    this->Z[lane] = point.z();
  }
  Eigen::Vector3d Get(int lane) const { return { this->X[lane], this->Y[lane], this->Z[lane] }; }
};

/// The state of all walks, lane by lane: what SliceCurve holds for one.
struct alignas(64) LaneState
{
  LanePoint Origin{};
  LanePoint Normal{};
  LanePoint Start{};
  LanePoint End{};
  Lane StartDistance{};
  Lane EndDistance{};
  LanePoint Apex{}; ///< the point that the next step comes to
  LanePoint PathEnd{};
  LanePoint Moment{};
  Lane Length{};
  LanePoint Target{};
  Lane Offset{};
  Lane Bound{};
  Lane SideOfStart{}; ///< 1 where the apex lies on the side of the start
  Lane Exceeds{};     ///< 1 where the bound is exceeded
};

/// One step of SliceWalker::Follow in every lane, operation by operation.
marrow_ALWAYS_INLINE void StepOf(LaneState& s)
{
  for (int i = 0; i < Count; ++i)
  {
    const double apexX = s.Apex.X[i];
    const double apexY = s.Apex.Y[i];
    const double apexZ = s.Apex.Z[i];
    const double apexDistance = s.Normal.X[i] * (apexX - s.Origin.X[i]) +
      s.Normal.Y[i] * (apexY - s.Origin.Y[i]) + s.Normal.Z[i] * (apexZ - s.Origin.Z[i]);
    const bool same = (apexDistance >= 0.0) == (s.StartDistance[i] >= 0.0);
    const double startX = same ? apexX : s.Start.X[i];
    const double startY = same ? apexY : s.Start.Y[i];
    const double startZ = same ? apexZ : s.Start.Z[i];
    const double startDistance = same ? apexDistance : s.StartDistance[i];
    const double endX = same ? s.End.X[i] : apexX;
    const double endY = same ? s.End.Y[i] : apexY;
    const double endZ = same ? s.End.Z[i] : apexZ;
    const double endDistance = same ? s.EndDistance[i] : apexDistance;
    const double share = startDistance / (startDistance - endDistance);
    const double x = startX + share * (endX - startX);
    const double y = startY + share * (endY - startY);
    const double z = startZ + share * (endZ - startZ);
    const double dx = x - s.PathEnd.X[i];
    const double dy = y - s.PathEnd.Y[i];
    const double dz = z - s.PathEnd.Z[i];
    const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
    s.Length[i] += length;
    s.Moment.X[i] += length * (s.PathEnd.X[i] + x);
    s.Moment.Y[i] += length * (s.PathEnd.Y[i] + y);
    s.Moment.Z[i] += length * (s.PathEnd.Z[i] + z);
    s.PathEnd.X[i] = x;
    s.PathEnd.Y[i] = y;
    s.PathEnd.Z[i] = z;
    s.Start.X[i] = startX;
    s.Start.Y[i] = startY;
    s.Start.Z[i] = startZ;
    s.StartDistance[i] = startDistance;
    s.End.X[i] = endX;
    s.End.Y[i] = endY;
    s.End.Z[i] = endZ;
    s.EndDistance[i] = endDistance;
    s.SideOfStart[i] = same ? 1.0 : 0.0;
  }
}

marrow_ALWAYS_INLINE void CheckBoundsOf(LaneState& s)
{
  for (int i = 0; i < Count; ++i)
  {
    const double dx = s.PathEnd.X[i] - s.Target.X[i];
    const double dy = s.PathEnd.Y[i] - s.Target.Y[i];
    const double dz = s.PathEnd.Z[i] - s.Target.Z[i];
    const double back = std::sqrt(dx * dx + dy * dy + dz * dz);
    s.Exceeds[i] = s.Offset[i] + s.Length[i] + back > s.Bound[i] ? 1.0 : 0.0;
  }
}

using Kernel = void (*)(LaneState&);

void StepBaseline(LaneState& state)
{
  StepOf(state);
}
void CheckBoundsBaseline(LaneState& state)
{
  CheckBoundsOf(state);
}
#ifdef marrow_HAS_TARGETS
marrow_TARGET("avx2") void StepAVX2(LaneState& state)
{
  StepOf(state);
}
marrow_TARGET("avx2") void CheckBoundsAVX2(LaneState& state)
{
  CheckBoundsOf(state);
}
marrow_TARGET("avx512f") void StepAVX512(LaneState& state)
{
  StepOf(state);
}
marrow_TARGET("avx512f") void CheckBoundsAVX512(LaneState& state)
{
  CheckBoundsOf(state);
}
#endif

struct Kernels
{
  Kernel Step = StepBaseline;
  Kernel CheckBounds = CheckBoundsBaseline;
};

Kernels KernelsFor(VectorUnits units)
{
#ifdef marrow_HAS_TARGETS
  switch (units)
  {
    case VectorUnits::AVX2:
      return { StepAVX2, CheckBoundsAVX2 };
    case VectorUnits::AVX512:
      return { StepAVX512, CheckBoundsAVX512 };
    case VectorUnits::Baseline:
      break;
  }
#else
  static_cast<void>(units);
#endif
  return {};
}

class LaneRun
{
public:
  LaneRun(const SliceMesh& mesh, const std::function<SliceCurve*(int)>& nextCurve, Kernels kernels)
    : Mesh(mesh)
    , NextCurve(nextCurve)
    , Use(kernels)
  {
  }

  void Run()
  {
    for (int lane = 0; lane < Count; ++lane)
    {
      this->Load(lane);
    }
    this->Started = true;
    while (this->NumberActive > 0)
    {
      for (int step = 0; step < StepsPerBoundCheck; ++step)
      {
        this->Step();
      }
      this->Use.CheckBounds(this->State);
      for (int lane = 0; lane < Count; ++lane)
      {
        // The step limit guards against a mesh that is not what it claims to be.
        if (this->Curves[lane] &&
          (this->State.Exceeds[lane] > 0.0 || ++this->Rounds[lane] > this->Mesh.HalfEdges.size()))
        {
          this->Curves[lane]->Path.Abandoned = true;
          this->Store(lane);
          this->Load(lane);
        }
      }
    }
  }

private:
  void Step()
  {
    const SliceMesh::HalfEdge* const halfEdges = this->Mesh.HalfEdges.data();
    const Eigen::Vector3d* const points = this->Mesh.Points.data();
    for (int lane = 0; lane < Count; ++lane)
    {
      while (
        this->HalfEdges[lane] < 0 || halfEdges[this->HalfEdges[lane]].Apex == this->Vertices[lane])
      {
        this->Store(lane);
        this->Load(lane);
      }
      this->State.Apex.Set(lane, points[halfEdges[this->HalfEdges[lane]].Apex]);
    }
    this->Use.Step(this->State);
    for (int lane = 0; lane < Count; ++lane)
    {
      // No branch: it would go either way as often as not.
      this->HalfEdges[lane] =
        halfEdges[this->HalfEdges[lane]].Onward[static_cast<int>(this->State.SideOfStart[lane])];
    }
  }

  /// Puts the next curve into a lane.
  void Load(int lane)
  {
    const bool wasActive = this->Curves[lane] != nullptr;
    SliceCurve* curve = wasActive || !this->Started ? this->NextCurve(lane) : nullptr;
    this->NumberActive += (curve ? 1 : 0) - (wasActive ? 1 : 0);
    this->Curves[lane] = curve;
    if (!curve)
    {
      // A lane that rests walks about for nobody.
      this->HalfEdges[lane] = 0;
      this->Vertices[lane] = -1;
      return;
    }
    LaneState& s = this->State;
    this->HalfEdges[lane] = curve->HalfEdge;
    this->Vertices[lane] = curve->Vertex;
    this->Rounds[lane] = 0;
    s.Origin.Set(lane, curve->Origin);
    s.Normal.Set(lane, curve->Normal);
    s.Start.Set(lane, curve->Start);
    s.End.Set(lane, curve->End);
    s.StartDistance[lane] = curve->StartDistance;
    s.EndDistance[lane] = curve->EndDistance;
    s.PathEnd.Set(lane, curve->Path.End);
    s.Moment.Set(lane, curve->Path.Moment);
    s.Length[lane] = curve->Path.Length;
    s.Target.Set(lane, curve->Target);
    s.Offset[lane] = curve->Offset;
    s.Bound[lane] = curve->Bound;
  }

  /// Gives a lane's path back to its curve.
  void Store(int lane)
  {
    if (!this->Curves[lane])
    {
      return;
    }
    SlicePath& path = this->Curves[lane]->Path;
    path.Length = this->State.Length[lane];
    path.Moment = this->State.Moment.Get(lane);
    path.End = this->State.PathEnd.Get(lane);
    if (!path.Abandoned && this->HalfEdges[lane] >= 0)
    {
      path.LineTo(this->Curves[lane]->Origin);
      path.Closed = true;
    }
  }

  const SliceMesh& Mesh;
  const std::function<SliceCurve*(int)>& NextCurve;
  Kernels Use;
  LaneState State;
  std::array<SliceCurve*, Count> Curves{};
  std::array<int, Count> HalfEdges{};
  std::array<int, Count> Vertices{};
  std::array<std::size_t, Count> Rounds{};
  int NumberActive = 0;
  bool Started = false;
};
}

void FollowInLanes(
  const SliceMesh& mesh, const std::function<SliceCurve*(int lane)>& nextCurve, VectorUnits units)
{
  LaneRun(mesh, nextCurve, KernelsFor(units)).Run();
}
}
