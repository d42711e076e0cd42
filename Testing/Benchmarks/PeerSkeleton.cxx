// SPDX-License-Identifier: BSD-3-Clause
#include "PeerSkeleton.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

namespace marrow::bench
{
int PeerSkeletonSize(const TriangleMesh& mesh)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
  SurfaceMesh surface;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (mesh.Outgoing[v] < 0)
    {
      return 0;
    }
    const auto& p = mesh.Points[v];
    surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  }
  for (const auto& t : mesh.Triangles)
  {
    surface.add_face(SurfaceMesh::Vertex_index(t[0]), SurfaceMesh::Vertex_index(t[1]),
      SurfaceMesh::Vertex_index(t[2]));
  }
  CGAL::Mean_curvature_flow_skeletonization<SurfaceMesh>::Skeleton skeleton;
  CGAL::extract_mean_curvature_flow_skeleton(surface, skeleton);
  return static_cast<int>(boost::num_vertices(skeleton));
}
}
