// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReading.h"

#include <filesystem>

using marrow::test::Read;
using marrow::test::Reading;

namespace
{
Reading ReadText(const std::string& text)
{
  return marrow::test::ReadText(".off", text);
}

const std::string Corners = "0 0 0\n1 0 0\n0 1 0\n";
using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;
}

TEST(OFFReader, TrianglesKeepTheirNumbers)
{
  const Reading reading =
    ReadText("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1.5 -1e-3 +2\n3 2 0 1\n3 1 3 2\n");
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfPoints(), 4);
  ASSERT_EQ(reading.Mesh->GetNumberOfCells(), 2);
  EXPECT_EQ(reading.Cell(0), (Ids{ 2, 0, 1 }));
  EXPECT_EQ(reading.Cell(1), (Ids{ 1, 3, 2 }));
  EXPECT_EQ(reading.Mesh->GetPoint(3)[1], -1e-3);
  EXPECT_EQ(reading.Mesh->GetPoint(3)[2], 2.0);
  EXPECT_EQ(reading.Mesh->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(reading.Mesh->GetPointData()->GetNumberOfArrays(), 0);
}

TEST(OFFReader, CommentsBlankLinesAndLineEndsDoNotMatter)
{
  const Reading reading =
    ReadText("# a comment first\r\n\r\nOFF # and here\r\n\r\n3 1 0 # counts\r\n"
             "0 0 0 # x y z\r\n# between\r\n1 0 0\r\n\r\n0 1 0\r\n3 0 1 2");
  EXPECT_EQ(reading.Messages, "");
  EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 3);
  EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 2 }));
}

TEST(OFFReader, CountsMayFollowTheHeaderOnItsLine)
{
  EXPECT_EQ(ReadText("OFF 3 1 0\n" + Corners + "3 0 1 2\n").Mesh->GetNumberOfCells(), 1);
  EXPECT_EQ(ReadText("OFF3 1\n" + Corners + "3 0 1 2\n").Mesh->GetNumberOfCells(), 1);
}

TEST(OFFReader, RecordsMayGoOnInTheNextLine)
{
  const Reading reading = ReadText("OFF\n3 1 0\n0 0\n0\n1 0 0\n0 1 0\n3 0\n1 2\n");
  EXPECT_EQ(reading.Messages, "");
  EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 2 }));
}

TEST(OFFReader, ColoursOfPoints)
{
  const std::string face = "3 0 1 2\n";
  const Reading three = ReadText("COFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 255 0 300\n" + face);
  EXPECT_EQ(three.Point("Colors", 0), (Values{ 1, 2, 3, 255 }));
  EXPECT_EQ(three.Point("Colors", 2), (Values{ 255, 0, 255, 255 }));
  const Reading four =
    ReadText("COFF\n3 1 0\n0 0 0 1 2 3 4\n1 0 0 4 5 6 7\n0 1 0 7 8 9 10\n" + face);
  EXPECT_EQ(four.Point("Colors", 2), (Values{ 7, 8, 9, 10 }));
  const Reading fractions =
    ReadText("COFF\n3 1 0\n0 0 0 1.0 0 0.2 1\n1 0 0 0.0 1 0 1\n0 1 0 0.0 0 1 0\n" + face);
  EXPECT_EQ(fractions.Point("Colors", 0), (Values{ 255, 0, 51, 255 }));
  EXPECT_EQ(fractions.Point("Colors", 2), (Values{ 0, 0, 255, 0 }));
}

TEST(OFFReader, NormalsWithColoursInEitherOrderOfTheHeader)
{
  for (const std::string header : { "CNOFF", "NCOFF" })
  {
    const Reading reading = ReadText(header +
      "\n3 1 0\n0 0 0 0 0 1 9 8 7\n1 0 0 0 1 0 6 5 4\n"
      "0 1 0 1 0 0 3 2 1\n3 0 1 2\n");
    EXPECT_EQ(reading.Messages, "");
    EXPECT_EQ(reading.Point("Normals", 1), (Values{ 0, 1, 0 }));
    EXPECT_EQ(reading.Point("Colors", 1), (Values{ 6, 5, 4, 255 }));
    EXPECT_NE(reading.Mesh->GetPointData()->GetNormals(), nullptr);
  }
}

TEST(OFFReader, HomogeneousAndTextureCoordinates)
{
  const Reading homogeneous = ReadText("4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 4 0 4\n3 0 1 2\n");
  EXPECT_EQ(homogeneous.Mesh->GetPoint(1)[0], 1.0);
  EXPECT_EQ(homogeneous.Mesh->GetPoint(2)[1], 1.0);
  const Reading texture =
    ReadText("STNOFF\n3 1 0\n0 0 0 0 0 1 .5 .25\n1 0 0 0 0 1 1 0\n0 1 0 0 0 1 0 1\n3 0 1 2\n");
  EXPECT_EQ(texture.Point("TextureCoordinates", 0), (Values{ 0.5, 0.25 }));
  EXPECT_EQ(texture.Point("Normals", 0), (Values{ 0, 0, 1 }));
}

TEST(OFFReader, ColoursOfFaces)
{
  const Reading reading = ReadText("OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                   "3 0 1 2\n4 0 1 2 3 10 20 30\n3 0 2 3 0.0 1.0 0.0 1.0\n");
  ASSERT_EQ(reading.Mesh->GetNumberOfCells(), 3);
  EXPECT_EQ(reading.Face("Colors", 0), (Values{ 170, 170, 170, 255 })) << "it has none";
  EXPECT_EQ(reading.Face("Colors", 1), (Values{ 10, 20, 30, 255 }));
  EXPECT_EQ(reading.Face("Colors", 2), (Values{ 0, 255, 0, 255 }));
}

TEST(OFFReader, EveryFaceStaysAPolygon)
{
  const Reading reading = ReadText("OFF\n5 7 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n1 2 0\n"
                                   "3 0 1 2\n5 0 1 2 3 4\n2 0 1\n1 3\n3 2 2 0\n3 0 1 2\n0\n");
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 7);
  EXPECT_EQ(reading.Cell(1), (Ids{ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(reading.Cell(2), (Ids{ 0, 1, 1 })) << "a cell that vtkPolyData can hold";
  EXPECT_EQ(reading.Cell(3), (Ids{ 3, 3, 3 }));
  EXPECT_EQ(reading.Cell(4), (Ids{ 2, 2, 0 }));
  EXPECT_EQ(reading.Cell(5), reading.Cell(0)) << "a face twice";
  EXPECT_EQ(reading.Cell(6), (Ids{ 0, 0, 0 }));
}

TEST(OFFReader, BinaryFilesWithAllThatAHeaderCanPromise)
{
  using marrow::test::BigEndian;
  const auto color = BigEndian(1.0F) + BigEndian(0.2F) + BigEndian(0.0F);
  std::string file = "STCN4OFF BINARY\n" + BigEndian(3) + BigEndian(2) + BigEndian(0);
  for (int i = 0; i < 3; ++i)
  {
    for (const float value : { 2.0F * (i == 1), 2.0F * (i == 2), 0.0F, 2.0F, 0.0F, 0.0F, 1.0F })
    {
      file += BigEndian(value);
    }
    file += color + BigEndian(0.0F) + BigEndian(0.5F) + BigEndian(0.25F);
  }
  const std::string corners = BigEndian(0) + BigEndian(1) + BigEndian(2);
  file += BigEndian(3) + corners + BigEndian(0);
  file += BigEndian(3) + corners + BigEndian(3) + color;
  const Reading reading = ReadText(file);
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfCells(), 2);
  EXPECT_EQ(reading.Cell(1), (Ids{ 0, 1, 2 }));
  EXPECT_EQ(reading.Mesh->GetPoint(1)[0], 1.0);
  EXPECT_EQ(reading.Point("Normals", 2), (Values{ 0, 0, 1 }));
  EXPECT_EQ(reading.Point("Colors", 2), (Values{ 255, 51, 0, 0 }));
  EXPECT_EQ(reading.Point("TextureCoordinates", 2), (Values{ 0.5, 0.25 }));
  EXPECT_EQ(reading.Face("Colors", 0), (Values{ 170, 170, 170, 255 }));
  EXPECT_EQ(reading.Face("Colors", 1), (Values{ 255, 51, 0, 255 }));

  for (std::size_t size = file.find('\n') + 1; size < file.size(); size += 7)
  {
    EXPECT_TRUE(ReadText(file.substr(0, size)).Has("is not a valid OFF file: it")) << size;
  }
  EXPECT_TRUE(
    ReadText("OFF BINARY\n" + BigEndian(1) + BigEndian(1) + BigEndian(0) + BigEndian(0.0F) +
      BigEndian(0.0F) + BigEndian(0.0F) + BigEndian(1) + BigEndian(7) + BigEndian(0))
      .Has("byte 43 makes face 0 use vertex 7, but the 1 vertices are numbered from 0."));
}

TEST(OFFReader, EmptySurfaceIsAnError)
{
  EXPECT_TRUE(ReadText("OFF\n0 0 0\n").Has("holds no surface"));
}

TEST(OFFReader, SaysWhatIsWrongAndWhere)
{
  struct Case
  {
    std::string Text;
    std::string Message;
  };
  const Case cases[] = {
    { "", "is not a valid OFF file: it is empty." },
    { "ply\nformat ascii 1.0\n", "it begins with \"ply\" instead of OFF." },
    { "3 1 0\n" + Corners + "3 0 1 2\n", "it begins with \"3\" instead of OFF." },
    { std::string("\x7f\x45\x01\x02", 4),
      "it begins with bytes that are not text instead of OFF." },
    { "OFF\n", "it ends after the header." },
    { "OFF\nthree 1 0\n",
      "line 2 should hold the numbers of vertices and faces but begins with "
      "\"three\"." },
    { "OFF\n-3 1 0\n", "line 2 should hold the numbers" },
    { "nOFF\n2\n", "is an n-dimensional OFF file, which is not supported" },
    { "OFF\n3 1 0\n0 0 0\n1 0 0\n", "it ends after 2 of 3 vertices." },
    { "OFF\n2000000000 1 0\n0 0 0\n", "it ends after 1 of 2000000000 vertices." },
    { "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n",
      "line 4 has \"x\" where vertex 1 needs a number." },
    { "4OFF\n1 0 0\n1 2 3 0\n", "line 3 puts vertex 0 at infinity." },
    { "OFF\n3 2 0\n" + Corners + "3 0 1 2\n", "it ends after 1 of 2 faces." },
    { "OFF\n3 1 0\n" + Corners + "3 0 1\n", "it ends after 0 of 1 faces." },
    { "OFF\n3 1 0\n" + Corners + "1999999999 0 1\n", "it ends after 0 of 1 faces." },
    { "OFF\n3 1 0\n" + Corners + "3 0 1 3\n",
      "line 6 makes face 0 use vertex 3, but the 3 vertices are numbered from 0." },
    { "OFF\n3 1 0\n" + Corners + "3 0 -1 2\n", "line 6 makes face 0 use vertex -1" },
    { "OFF\n3 1 0\n" + Corners + "3 0 1.5 2\n",
      "line 6 has \"1.5\" where face 0 needs the number of a vertex." },
    { "OFF\n3 1 0\n" + Corners + "-3 0 1 2\n",
      "line 6 has \"-3\" where the number of corners of face 0 should be." },
  };
  for (const Case& example : cases)
  {
    const Reading reading = ReadText(example.Text);
    EXPECT_NE(reading.Messages.find(example.Message), std::string::npos)
      << "expected: " << example.Message << "\nheard: " << reading.Messages;
    EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 0);
  }
}

TEST(OFFReader, SaysThatThereIsNoFile)
{
  EXPECT_NE(Read(nullptr).Messages.find("There is no file name: set FileName."), std::string::npos);
  EXPECT_NE(Read("").Messages.find("There is no file name"), std::string::npos);
  EXPECT_NE(Read("/nowhere/at/all.off")
              .Messages.find("Cannot read \"/nowhere/at/all.off\": No such file or directory"),
    std::string::npos);
  const std::string folder = ::testing::TempDir() + "marrow_folder.off";
  std::filesystem::create_directory(folder);
  EXPECT_TRUE(Read(folder.c_str()).Has("it is a folder"));
  std::filesystem::remove(folder);
  EXPECT_TRUE(Read("mesh.txt").Has("the name must end in .off, .ply, .obj,"));
}
