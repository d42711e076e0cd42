// SPDX-License-Identifier: BSD-3-Clause
// What the stages give on procedural creatures, as pictures: one line each, with its threshold.
#include "ImageComparison.h"

#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkMSPField.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowSideBySideScene.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkPolyData.h>
#include <vtkSegmentationTransfer.h>
#include <vtkSkeletonCorrespondence.h>

using marrow::test::ExpectImage;

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

/// A labelled creature, seed 1 in its rest pose and all others bent and of other proportions.
Data Creature(int shape, int seed)
{
  vtkNew<vtkCreatureSource> creature;
  creature->SetShape(shape);
  creature->SetSeed(seed);
  creature->SetResolution(4000);
  creature->SetPose(seed == 1 ? 0.0 : 0.5);
  creature->SetProportion(seed == 1 ? 0.0 : 0.5);
  creature->Update();
  return creature->GetOutput();
}

Data SkeletonOf(vtkPolyData* mesh)
{
  vtkNew<vtkMSPSkeleton> skeleton;
  skeleton->SetInputData(mesh);
  skeleton->Update();
  return vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(0));
}

vtkSmartPointer<vtkImageData> Draw(vtkMarrowSideBySideScene* scene)
{
  scene->SetTileWidth(200);
  scene->SetTileHeight(180);
  auto image = vtkSmartPointer<vtkImageData>::New();
  EXPECT_TRUE(scene->Render(image));
  return image;
}

/// The measures on the creature, with their scalar bars.
vtkSmartPointer<vtkImageData> DrawMeasures(int shape)
{
  vtkNew<vtkMSPField> measures;
  measures->SetInputData(Creature(shape, 1));
  measures->Update();
  vtkNew<vtkMarrowSideBySideScene> scene;
  for (const char* name : { "AGD", "MSP", "MSPGradient" })
  {
    scene->SetSurfaceArray(scene->AddMesh(measures->GetOutput()), name);
  }
  return Draw(scene);
}

/// The skeleton inside of the creature.
vtkSmartPointer<vtkImageData> DrawSkeleton(int shape)
{
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetSurfaceOpacity(0.3);
  const Data mesh = Creature(shape, 1);
  scene->AddMesh(mesh, SkeletonOf(mesh));
  return Draw(scene);
}

/// The skeletons of two creatures of a kind, matched parts in equal colours, the surfaces grey: their
/// labels have the same colours.
vtkSmartPointer<vtkImageData> DrawCorrespondence(int shape)
{
  vtkNew<vtkSkeletonCorrespondence> correspondence;
  const Data meshes[2] = { Creature(shape, 1), Creature(shape, 2) };
  for (const Data& mesh : meshes)
  {
    mesh->GetCellData()->RemoveArray("SegmentId");
  }
  correspondence->SetInputData(0, SkeletonOf(meshes[0]));
  correspondence->SetInputData(1, SkeletonOf(meshes[1]));
  correspondence->Update();
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->SetSurfaceOpacity(0.15);
  scene->SetColorSkeletonBy(vtkMarrowSkeletonGlyphs::CORRESPONDENCE);
  scene->ShowLinksOn();
  for (int i = 0; i < 2; ++i)
  {
    scene->AddMesh(meshes[i], vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(i)));
  }
  return Draw(scene);
}

/// A labelled creature and the one its segments went to.
vtkSmartPointer<vtkImageData> DrawTransfer(int shape)
{
  const Data source = Creature(shape, 1);
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, source);
  transfer->SetInputData(1, Creature(shape, 2));
  transfer->Update();
  vtkNew<vtkMarrowSideBySideScene> scene;
  scene->AddMesh(source);
  scene->AddMesh(vtkPolyData::SafeDownCast(transfer->GetOutputDataObject(0)));
  return Draw(scene);
}
}

// Runs on one machine give the same bits (error 0). The thresholds leave room for another graphics
// driver's edges; a node that moves by a ball's radius, or a boundary by an edge, is above them.
// clang-format off
TEST(Images, MeasuresOfQuadruped) { ExpectImage(DrawMeasures(vtkCreatureSource::QUADRUPED), "MeasuresOfQuadruped", 50); }
TEST(Images, SkeletonOfQuadruped) { ExpectImage(DrawSkeleton(vtkCreatureSource::QUADRUPED), "SkeletonOfQuadruped", 50); }
TEST(Images, SkeletonOfChair) { ExpectImage(DrawSkeleton(vtkCreatureSource::CHAIR), "SkeletonOfChair", 50); }
TEST(Images, CorrespondenceOfQuadrupeds) { ExpectImage(DrawCorrespondence(vtkCreatureSource::QUADRUPED), "CorrespondenceOfQuadrupeds", 50); }
TEST(Images, CorrespondenceOfBipeds) { ExpectImage(DrawCorrespondence(vtkCreatureSource::BIPED), "CorrespondenceOfBipeds", 50); }
TEST(Images, TransferBetweenQuadrupeds) { ExpectImage(DrawTransfer(vtkCreatureSource::QUADRUPED), "TransferBetweenQuadrupeds", 50); }
TEST(Images, TransferBetweenBipeds) { ExpectImage(DrawTransfer(vtkCreatureSource::BIPED), "TransferBetweenBipeds", 50); }
// clang-format on
