// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReading.h"

#include <vtkFieldData.h>
#include <vtkStringArray.h>

using marrow::test::Reading;

namespace
{
Reading ReadText(const std::string& text)
{
  return marrow::test::ReadText(".obj", text);
}

std::vector<std::string> Names(const Reading& reading, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(reading.Mesh->GetFieldData()->GetAbstractArray(name));
  std::vector<std::string> names;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    names.push_back(array->GetValue(i));
  }
  return names;
}

const std::string Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;
using Strings = std::vector<std::string>;
}

TEST(OBJReader, AllKindsOfCornersMixed)
{
  const Reading reading = ReadText(Square +
    "vt 0 0\nf 1 2 3 4\nf 1//1 2//1 3//1\nf 1/1 2/1 3/1\nf 1/1/1 2//9 3\nf -4 -3 -1\nf 1 1 2\nf 3 "
    "4\n"
    "f 2\n");
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 8);
  EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 4);
  EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 2, 3 }));
  for (const vtkIdType face : { 1, 2, 3 })
  {
    EXPECT_EQ(reading.Cell(face), (Ids{ 0, 1, 2 }));
  }
  EXPECT_EQ(reading.Cell(4), (Ids{ 0, 1, 3 }));
  EXPECT_EQ(reading.Cell(5), (Ids{ 0, 0, 1 }));
  EXPECT_EQ(reading.Cell(6), (Ids{ 2, 3, 3 }));
  EXPECT_EQ(reading.Cell(7), (Ids{ 1, 1, 1 }));
}

TEST(OBJReader, WhatPeoplesFilesHaveBeside)
{
  const Reading reading =
    ReadText("\xEF\xBB\xBF# made by hand\r\nmtllib absent.mtl\r\nusemtl \r\ns off\r\n"
             "f 1 2 \\\r\n  3 # before its vertices\r\n"
             "\tv 4512345.125 0.1 -1e-3 1 0 0.2\r\n v\t1 0 0\r\nv 0 1 0 1.0\r\n"
             "vn 0 0 1\r\nl 1 2\r\np 1\r\ncstype bspline\r\nf 3 2 1");
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 2 }));
  EXPECT_EQ(reading.Cell(1), (Ids{ 2, 1, 0 }));
  EXPECT_EQ(reading.Mesh->GetPoint(0)[0], 4512345.125);
  EXPECT_EQ(reading.Mesh->GetPoint(0)[1], 0.1);
  EXPECT_EQ(reading.Point("Colors", 0), (Values{ 255, 0, 51, 255 }));
  EXPECT_EQ(reading.Point("Colors", 2), (Values{ 255, 255, 255, 255 }));
  EXPECT_FALSE(reading.Mesh->GetCellData()->HasArray("MaterialId")) << "it has no name";
}

TEST(OBJReader, PartsOfAFileAreNumberedByTheirNames)
{
  const Reading numbered =
    ReadText(Square + "g leg12\nf 1 2 3\ng leg3\nf 1 2 3\nf 1 2 3\ng leg12\nf 1 2 3\n");
  EXPECT_EQ(numbered.Face("GroupId", 0), (Values{ 12 }));
  EXPECT_EQ(numbered.Face("GroupId", 2), (Values{ 3 }));
  EXPECT_EQ(numbered.Face("GroupId", 3), (Values{ 12 }));
  EXPECT_EQ(Names(numbered, "GroupName").at(12), "leg12");

  const Reading named = ReadText(
    Square + "f 1 2 3\no the tail\nusemtl b#1\nf 1 2 3\no head\ng left arm\nusemtl a#1\nf 1 2 3\n");
  EXPECT_EQ(Names(named, "ObjectName"), (Strings{ "", "head", "the tail" }));
  EXPECT_EQ(named.Face("ObjectId", 1), (Values{ 2 }));
  EXPECT_EQ(Names(named, "MaterialName"), (Strings{ "", "a#1", "b#1" }));
  EXPECT_EQ(named.Face("MaterialId", 2), (Values{ 1 }));
  EXPECT_EQ(Names(named, "GroupName"), (Strings{ "", "left arm" }));
}

TEST(OBJReader, SaysWhatIsWrongAndWhere)
{
  const std::pair<std::string, std::string> cases[] = {
    { "", "holds no surface" },
    { Square + "usemtl a\nl 1 2 4 3\nl 1 2\n", "holds no surface" },
    { Square + "f 1 2 5\nf 1 2 3\n",
      "line 5 makes a face use vertex 5, but the 4 vertices are numbered from 1." },
    { Square + "f 1 2 3\nf 1 2 99999999999999\n", "line 6 makes a face use vertex 99999999999999" },
    { Square + "f 0 1 2\n", "line 5 makes a face use vertex 0" },
    { Square + "f -1 -2 -5\n", "line 5 makes a face use vertex -5" },
    { Square + "f 1 2 \\\n3 \\\n9\nf a b c\n", "line 8 has \"a\" where a face needs" },
    { Square + "f 1 /2 3\n", "line 5 has \"/2\" where a face needs the number of a vertex" },
    { "v 0 0\n", "line 1 has fewer than three coordinates for vertex 1" },
    { "v 0 0 0\nv 0 0,5 0\n", "line 2 has \"0,5\" where vertex 2 needs a number" },
  };
  for (const auto& [text, message] : cases)
  {
    const Reading reading = ReadText(text);
    EXPECT_TRUE(reading.Has(message)) << "expected: " << message << "\nheard: " << reading.Messages;
    EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 0);
  }
}
