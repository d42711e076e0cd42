// SPDX-License-Identifier: BSD-3-Clause
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkLookupTable.h>
#include <vtkMarrowLabelColors.h>
#include <vtkMarrowMeasureColors.h>
#include <vtkNew.h>
#include <vtkVariant.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
Eigen::Vector3d LabelColor(vtkIdType label)
{
  Eigen::Vector3d rgb;
  vtkMarrowLabelColors::GetColor(label, rgb.data());
  return rgb;
}

/// What people see: the matrices of Machado, Oliveira and Fernandes 2009 for full deficiency, on
/// linear RGB.
const Eigen::Matrix3d* Visions()
{
  static Eigen::Matrix3d visions[4];
  visions[0].setIdentity();
  visions[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
    1.051998;
  visions[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
    0.968881;
  visions[3] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
    0.303900;
  return visions;
}

/// sRGB seen so, in CIE Lab (D65).
Eigen::Vector3d Lab(const Eigen::Vector3d& rgb, const Eigen::Matrix3d& vision)
{
  const auto linear = [](double c)
  { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  Eigen::Matrix3d toXyz;
  toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d seen = (vision * rgb.unaryExpr(linear)).cwiseMax(0.0).cwiseMin(1.0);
  const Eigen::Vector3d xyz = (toXyz * seen).cwiseQuotient(Eigen::Vector3d(0.95047, 1.0, 1.08883));
  const auto cubeRoot = [](double t)
  { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const Eigen::Vector3d f = xyz.unaryExpr(cubeRoot);
  return { 116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z()) };
}

vtkSmartPointer<vtkDoubleArray> Values(std::initializer_list<double> values, int repeat = 1)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (int i = 0; i < repeat; ++i)
  {
    for (double value : values)
    {
      array->InsertNextValue(value);
    }
  }
  return array;
}
}

TEST(LabelColors, AreToldApartWithColorDeficientVision)
{
  for (int vision = 0; vision < 4; ++vision)
  {
    for (vtkIdType a = -1; a < 24; ++a)
    {
      for (vtkIdType b = a + 1; b < 24; ++b)
      {
        const double difference =
          (Lab(LabelColor(a), Visions()[vision]) - Lab(LabelColor(b), Visions()[vision])).norm();
        EXPECT_GE(difference, b < 12 ? 16.0 : 14.0) << a << " and " << b << ", vision " << vision;
      }
    }
  }
}

TEST(LabelColors, RepeatAndAreGreyWhereThereIsNoLabel)
{
  EXPECT_EQ(LabelColor(24), LabelColor(0));
  EXPECT_EQ(LabelColor(-1), LabelColor(-7));
  EXPECT_EQ(LabelColor(-1).x(), LabelColor(-1).z());
}

TEST(LabelColors, ColorOfALabelDoesNotDependOnTheOthers)
{
  vtkNew<vtkIntArray> few;
  vtkNew<vtkIntArray> many;
  for (int label : { 7, 3 })
  {
    few->InsertNextValue(label);
  }
  for (int label : { 0, 1, -1, 3, 11, 7, 130 })
  {
    many->InsertNextValue(label);
  }
  vtkNew<vtkLookupTable> fewColors;
  vtkMarrowLabelColors::FillLookupTable(fewColors, few);
  vtkNew<vtkLookupTable> manyColors;
  vtkMarrowLabelColors::FillLookupTable(manyColors, many);
  for (int label : { 3, 7 })
  {
    double a[4];
    double b[4];
    fewColors->GetAnnotationColor(vtkVariant(label), a);
    manyColors->GetAnnotationColor(vtkVariant(label), b);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(a[k], LabelColor(label)[k], 1.0 / 255);
      EXPECT_EQ(a[k], b[k]);
    }
  }
}

TEST(MeasureColors, RangeIsThatOfTheValuesButForFewFarAbove)
{
  double range[2];
  vtkMarrowMeasureColors::GetRange(Values({ 2.0, 3.0, 4.0 }, 50), range);
  EXPECT_EQ(range[0], 2.0);
  EXPECT_EQ(range[1], 4.0);

  const vtkSmartPointer<vtkDoubleArray> outlier = Values({ 2.0, 3.0, 4.0 }, 50);
  outlier->SetValue(17, 1000.0);
  outlier->SetValue(18, std::nan(""));
  vtkMarrowMeasureColors::GetRange(outlier, range);
  EXPECT_EQ(range[0], 2.0);
  EXPECT_EQ(range[1], 4.0);

  vtkMarrowMeasureColors::GetRange(Values({ -1.0, 0.5 }, 50), range);
  EXPECT_EQ(range[0], -1.0);
  EXPECT_EQ(range[1], 1.0);

  vtkMarrowMeasureColors::GetRange(Values({ 3.0, 3.0 }), range);
  EXPECT_LT(range[0], range[1]);
  vtkMarrowMeasureColors::GetRange(Values({ std::nan("") }), range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 1.0);
}

TEST(MeasureColors, VectorsAreMeasuredByTheirLength)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->InsertNextTuple3(-3.0, 0.0, 4.0);
  vectors->InsertNextTuple3(0.0, -6.0, 0.0);
  double range[2];
  vtkMarrowMeasureColors::GetRange(vectors, range);
  EXPECT_DOUBLE_EQ(range[0], 5.0);
  EXPECT_DOUBLE_EQ(range[1], 6.0);
}

TEST(MeasureColors, GetBrighterOrDivergeFromWhite)
{
  vtkNew<vtkLookupTable> table;
  const double positive[2] = { 0.0, 1.0 };
  vtkMarrowMeasureColors::FillLookupTable(table, positive);
  double last = 0.0;
  for (double value : { 0.0, 0.2, 0.4, 0.6, 0.8, 1.0 })
  {
    Eigen::Vector3d rgb;
    table->GetColor(value, rgb.data());
    const double lightness = Lab(rgb, Visions()[0])[0];
    EXPECT_GT(lightness, last + 5.0) << value;
    last = lightness;
  }

  const double both[2] = { -2.0, 2.0 };
  vtkMarrowMeasureColors::FillLookupTable(table, both);
  double low[3];
  double middle[3];
  double high[3];
  table->GetColor(-1.3, low);
  table->GetColor(0.0, middle);
  table->GetColor(1.3, high);
  EXPECT_GT(low[2], low[0] + 0.3);   // blue
  EXPECT_GT(high[0], high[2] + 0.3); // vermilion
  EXPECT_GT(std::min({ middle[0], middle[1], middle[2] }), 0.9);
}
