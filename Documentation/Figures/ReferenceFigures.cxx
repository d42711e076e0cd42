// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include <vtkMarrowLabelColors.h>

#include <cmath>

namespace figures
{
namespace
{
Picture DrawCreatures(const std::string&)
{
  const auto scene = Scene(220, 220);
  scene->AlignOff();
  scene->SetColumns(4);
  scene->SetViewDirection(0.6, 0.0, 0.8);
  scene->SetAzimuth(-15);
  const char* names[] = { "biped", "quadruped", "octopus", "chair", "snake", "torus", "capsule" };
  for (int shape = 0; shape < 7; ++shape)
  {
    scene->AddMesh(
      Creature(shape, 1, shape == vtkCreatureSource::SNAKE ? 0.6 : 0.0), nullptr, names[shape]);
  }
  return Drawn(scene);
}

/// What makes a creature another individual.
Picture DrawIndividuals(const std::string&)
{
  const auto scene = Scene(215, 190);
  const auto add = [&](const char* caption, double pose, double proportion, double noise)
  {
    vtkNew<vtkCreatureSource> creature;
    creature->SetSeed(5);
    creature->SetPose(pose);
    creature->SetProportion(proportion);
    creature->SetNoise(noise);
    creature->Update();
    scene->AddMesh(creature->GetOutput(), nullptr, caption);
  };
  add("all 0", 0.0, 0.0, 0.0);
  add("Pose 1", 1.0, 0.0, 0.0);
  add("Proportion 1", 0.0, 1.0, 0.0);
  add("Noise 0.005", 0.0, 0.0, 0.005);
  return Drawn(scene);
}

/// The four meanings of a skeleton's colours.
Picture DrawColorBy(const std::string&)
{
  const Matched& pair = Quadrupeds();
  std::vector<Picture> pictures;
  const char* names[] = { "NODE_TYPE", "CORRESPONDENCE", "BRANCH", "LABEL" };
  for (int colorBy = 0; colorBy < 4; ++colorBy)
  {
    const auto scene = Scene(215, 190);
    scene->SetColorSkeletonBy(colorBy);
    scene->SetSurfaceOpacity(0.1);
    scene->AddMesh(pair.Source.Mesh, pair.Source.Skeleton, names[colorBy]);
    pictures.push_back(Drawn(scene));
  }
  return Beside(pictures);
}

/// As seen with deuteranopia (Machado, Oliveira and Fernandes 2009).
Color WithoutGreen(const Color& color)
{
  const double matrix[3][3] = { { 0.367322, 0.860646, -0.227968 }, { 0.280085, 0.672501, 0.047413 },
    { -0.011820, 0.042940, 0.968881 } };
  Color seen;
  for (int row = 0; row < 3; ++row)
  {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double c = color[k];
      sum += matrix[row][k] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    sum = std::fmin(std::fmax(sum, 0.0), 1.0);
    seen[row] = sum <= 0.0031308 ? 12.92 * sum : 1.055 * std::pow(sum, 1 / 2.4) - 0.055;
  }
  return seen;
}

Picture DrawLabels(const std::string&)
{
  constexpr int side = 50;
  Canvas canvas(200 + 12 * side, 4 * side + 60);
  for (int label = 0; label < 24; ++label)
  {
    Color color;
    vtkMarrowLabelColors::GetColor(label, color.data());
    const int line = label / 12;
    const double x = 180.0 + side * (label % 12);
    for (int row = 0; row < 2; ++row)
    {
      const double y = 20.0 + side * (3 - row - 2 * line) + (label < 12 ? 20.0 : 0.0);
      const Color shown = row == 0 ? color : WithoutGreen(color);
      canvas.Box({ x, y }, { x + side - 4, y + side - 4 }, shown);
      const double brightness = 0.3 * shown[0] + 0.6 * shown[1] + 0.1 * shown[2];
      canvas.Text({ x + 0.5 * side - 2, y + 0.5 * side - 2 }, std::to_string(label), 15,
        Canvas::Align::Center, brightness > 0.5 ? Black : Color{ 1.0, 1.0, 1.0 });
    }
  }
  for (int half = 0; half < 2; ++half)
  {
    const double y = 20.0 + side * (2 - 2 * half) + (half == 0 ? 20.0 : 0.0);
    canvas.Text({ 165, y + 1.5 * side }, "colours", 15, Canvas::Align::Right);
    canvas.Text({ 165, y + 0.5 * side }, "with deuteranopia", 15, Canvas::Align::Right);
  }
  return canvas.Draw();
}
}

Drawings ReferenceFigures()
{
  return { { "creatures", DrawCreatures }, { "labels", DrawLabels },
    { "parameter-creature", DrawIndividuals }, { "parameter-color-by", DrawColorBy } };
}
}
