// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReading.h"

#include <limits>

using marrow::test::LittleEndian;
using marrow::test::Reading;

namespace
{
Reading ReadText(const std::string& text)
{
  return marrow::test::ReadText(".stl", text);
}

std::string Facet(const std::string& third)
{
  return "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 -0.0 0\n  vertex " + third +
    "\n endloop\nendfacet\n";
}

/// Facets of the x coordinates of three corners.
std::string Binary(
  const std::vector<std::vector<float>>& facets, const std::string& header, int count)
{
  std::string text = header + std::string(80 - header.size(), ' ') + LittleEndian(count);
  for (const auto& facet : facets)
  {
    for (const float number : { 0.0F, 0.0F, 1.0F })
    {
      text += LittleEndian(number);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      text += LittleEndian(facet[k]) + LittleEndian(k == 2 ? 1.0F : 0.0F) + LittleEndian(0.0F);
    }
    text += LittleEndian(static_cast<short>(facet.size()));
  }
  return text;
}

using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;
}

TEST(STLReader, EqualCornersAreOnePointAndSolidsAreGroups)
{
  const Reading reading = ReadText("solid part1 of it\n" + Facet("0 1 0") + Facet("0 1 0") +
    "endsolid part1 of it\nSOLID\n" + Facet("0 1e-30 0") + "endsolid");
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 3);
  EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 4);
  EXPECT_EQ(reading.Cell(1), (Ids{ 0, 1, 2 }));
  EXPECT_EQ(reading.Cell(2), (Ids{ 0, 1, 3 })) << "near is not equal";
  EXPECT_EQ(reading.Face("GroupId", 0), (Values{ 1 }));
  EXPECT_EQ(reading.Face("GroupId", 2), (Values{ 0 }));
}

TEST(STLReader, BinaryFilesEvenIfTheyBeginWithSolid)
{
  constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
  for (const std::string header : { "solid by a bad writer", "", "COLOR=" })
  {
    const Reading reading =
      ReadText(Binary({ { 0, 1, 2 }, { 0, 1, 2 }, { 0, 0, NaN, 9 } }, header, 3));
    EXPECT_EQ(reading.Messages, "");
    ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 3);
    EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 4);
    EXPECT_EQ(reading.Cell(1), (Ids{ 0, 1, 2 }));
    EXPECT_EQ(reading.Cell(2), (Ids{ 0, 0, 3 })) << "a facet without area stays";
    EXPECT_EQ(reading.Face("Attribute", 2), (Values{ 4 }));
  }
}

TEST(STLReader, SaysWhatIsWrongAndWhere)
{
  const std::string binary = Binary({ { 0, 1, 2 } }, "", 2);
  const std::pair<std::string, std::string> cases[] = {
    { "", "it neither begins with solid nor has a binary header." },
    { "solid\nendsolid\n", "holds no surface" },
    { "solid\n" + Facet("0 x 0"), "line 6 has \"x\" where a vertex needs a number." },
    { "solid\nfacet\nvertex 1 2\n", "line 3 has nothing where a vertex needs a number." },
    { "solid\n" + Facet("0 1 0") + "facet\nvertex 0 0 0\n", "it ends within facet 1." },
    { binary, "it ends after 1 of 2 facets." },
    { binary.substr(0, 83), "it neither begins with solid" },
    { binary.substr(0, 84), "it ends after 0 of 2 facets." },
    { Binary({}, "", -1), "it promises more facets than can be numbered." },
  };
  for (const auto& [text, message] : cases)
  {
    const Reading reading = ReadText(text);
    EXPECT_TRUE(reading.Has(message)) << "expected: " << message << "\nheard: " << reading.Messages;
    EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 0);
  }
}
