// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SceneLinks_h
#define marrow_SceneLinks_h

#include "SceneTile.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkRenderWindow;
class vtkRenderer;

namespace marrow
{
/// Lines over the whole window from the nodes of the first tile's skeleton to those of the other
/// tiles' that have the same CorrespondenceId, in that id's colour. They follow the cameras.
class SceneLinks
{
public:
  /// A node of a skeleton as it is seen.
  struct End
  {
    vtkRenderer* Renderer;
    Eigen::Vector3d Position; ///< in the renderer's world
  };

  SceneLinks(const std::vector<SceneTile>& tiles, const std::vector<vtkRenderer*>& renderers);

  /// Adds the layer of the links; this object has to live as long as the window draws.
  void AddTo(vtkRenderWindow* window, double lineWidth);

  int NumberOfLinks() const { return static_cast<int>(this->Ends.size()) / 2; }

private:
  void Update();

  std::vector<End> Ends; ///< two a link
  std::vector<int> Ids;  ///< per link
  vtkNew<vtkPoints> Points;
  vtkSmartPointer<vtkRenderer> Overlay;
};
}

#endif
