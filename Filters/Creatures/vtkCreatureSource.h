// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCreatureSource
 * @brief   labelled procedural creatures with a known skeleton
 *
 * Makes a smooth closed surface of a creature (or a simple test shape) together with what a
 * segmentation and a skeleton of it ought to be: for tests, examples and documentation. The
 * creature is a tree of limbs, each a tube of varying radius about a smooth centre line; their
 * smooth union is contoured (surface nets) and the triangles are evened on the surface. y is up,
 * the front looks along x and the creature's right side is at z > 0. A creature is about two units
 * large.
 *
 * Output port 0, the surface: one component of consistently outward oriented triangles, a closed
 * 2-manifold whose genus is 0, but 1 for the torus and 3 for the chair. A pose in which limbs would
 * touch is drawn anew, so neither pose nor proportion changes the topology. Arrays:
 * - cells, SegmentId (int): the limb, see below; every segment is connected; the active scalars;
 * - points, SkeletonNodeId (vtkIdType): the point of the skeleton that the vertex belongs to.
 *
 * | shape | segments | terminals of the skeleton |
 * | --- | --- | --- |
 * | biped | 0 torso, 1 neck, 2 head, 3, 4 right and left arm, 5, 6 right and left leg | head, hands, feet: 5 |
 * | quadruped | 0 torso, 1 neck, 2 head, 3, 4 right and left front leg, 5, 6 hind leg, 7 tail | head, feet, tail: 6 |
 * | octopus | 0 mantle, 1 to 8 tentacles | mantle, tentacles: 9 |
 * | chair | 0 seat, 1 backrest, 2, 3 right and left armrest, 4 to 7 legs (front right, front left, back right, back left) | legs: 4, and 3 loops |
 * | snake | 0 body, 1 head, 2 tail | head, tail: 2 |
 * | torus | 0 and 1, its halves | none, 1 loop |
 * | capsule | 0, 1 and 2, its thirds along x | 2 |
 *
 * Output port 1, the skeleton after the data contract: points are nodes on the centre lines, one
 * polyline per branch; point arrays NodeType, Radius (mean distance to the vertices that belong to
 * the node), VertexCount; cell arrays BranchId, BranchLength; field array MeshDiagonal. There is no
 * AGD nor MSP: these are not known by construction.
 *
 * The same parameters give the same bits on any machine with IEEE arithmetic and any number of
 * threads.
 *
 * Error: the thinnest limbs are lost at so low a resolution.
 */
#ifndef vtkCreatureSource_h
#define vtkCreatureSource_h

#include "MarrowCreaturesModule.h"

#include <vtkPolyDataAlgorithm.h>

class MARROWCREATURES_EXPORT vtkCreatureSource : public vtkPolyDataAlgorithm
{
public:
  static vtkCreatureSource* New();
  vtkTypeMacro(vtkCreatureSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The shapes, with their segments and terminals in the table above.
   */
  enum ShapeType
  {
    BIPED = 0,
    QUADRUPED = 1,
    OCTOPUS = 2,
    CHAIR = 3,
    SNAKE = 4,
    TORUS = 5,
    CAPSULE = 6
  };

  ///@{
  /**
   * What to make. Default: QUADRUPED.
   */
  vtkSetClampMacro(Shape, int, BIPED, CAPSULE);
  vtkGetMacro(Shape, int);
  void SetShapeToBiped() { this->SetShape(BIPED); }
  void SetShapeToQuadruped() { this->SetShape(QUADRUPED); }
  void SetShapeToOctopus() { this->SetShape(OCTOPUS); }
  void SetShapeToChair() { this->SetShape(CHAIR); }
  void SetShapeToSnake() { this->SetShape(SNAKE); }
  void SetShapeToTorus() { this->SetShape(TORUS); }
  void SetShapeToCapsule() { this->SetShape(CAPSULE); }
  ///@}

  ///@{
  /**
   * How far the joints are bent from the rest pose, at random within what the joint allows: 0 is
   * the symmetric rest pose, 1 uses the full range. Default: 0. Range: [0, 1]. No effect on the
   * torus.
   */
  vtkSetClampMacro(Pose, double, 0.0, 1.0);
  vtkGetMacro(Pose, double);
  ///@}

  ///@{
  /**
   * How far the limbs' lengths and thicknesses vary at random, alike on the left and the right: at
   * 1 lengths by a factor of up to 1.35, thicknesses of up to 1.2, both ways. Default: 0. Range:
   * [0, 1].
   */
  vtkSetClampMacro(Proportion, double, 0.0, 1.0);
  vtkGetMacro(Proportion, double);
  ///@}

  ///@{
  /**
   * The number of triangles, kept within 10 %. Default: 10000. Range: [2000, 2000000]; below 5000 the
   * thinnest limbs of some individuals are lost, which is an error.
   */
  vtkSetClampMacro(Resolution, int, 2000, 2000000);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Every vertex is moved along its normal by up to this fraction of the bounding-box diagonal, at
   * random and each for itself. Default: 0. Range: [0, 0.02]; above the edge length (about 0.012 at
   * 10000 triangles) triangles fold over.
   */
  vtkSetClampMacro(Noise, double, 0.0, 0.02);
  vtkGetMacro(Noise, double);
  ///@}

  ///@{
  /**
   * Selects the individual: what Pose, Proportion and Noise draw. Default: 1. Range: [0, INT_MAX].
   */
  vtkSetClampMacro(Seed, int, 0, VTK_INT_MAX);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkCreatureSource();
  ~vtkCreatureSource() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Shape = QUADRUPED;
  double Pose = 0.0;
  double Proportion = 0.0;
  int Resolution = 10000;
  double Noise = 0.0;
  int Seed = 1;

private:
  vtkCreatureSource(const vtkCreatureSource&) = delete;
  void operator=(const vtkCreatureSource&) = delete;
};

#endif
