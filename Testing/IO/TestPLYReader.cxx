// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReading.h"

using marrow::test::BigEndian;
using marrow::test::LittleEndian;
using marrow::test::Reading;

namespace
{
Reading ReadText(const std::string& text)
{
  return marrow::test::ReadText(".ply", text);
}

std::string Header(const std::string& format, const std::string& vertex, const std::string& face,
  int vertices = 4, int faces = 2)
{
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " +
    std::to_string(vertices) + "\n" + vertex + "element face " + std::to_string(faces) + "\n" +
    face + "end_header\n";
}

const std::string Coordinates = "property float x\nproperty float y\nproperty float z\n";
const std::string Corners = "property list uchar int vertex_indices\n";
const std::string Square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;
}

TEST(PLYReader, TextWithoutEndOfTheLastLineAndOtherLineEnds)
{
  std::string text =
    "\xEF\xBB\xBF" + Header("ascii", Coordinates, Corners) + Square + "4 0 1 2 3\n3 0 1 2";
  for (int kind = 0; kind < 2; ++kind)
  {
    const Reading reading = ReadText(text);
    EXPECT_EQ(reading.Messages, "");
    ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 2);
    EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 2, 3 }));
    EXPECT_EQ(reading.Cell(1), (Ids{ 0, 1, 2 }));
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
    {
      text.replace(at, 1, "\r\n");
    }
  }
}

TEST(PLYReader, BinaryOfBothByteOrdersAndAnyTypes)
{
  const std::string vertex = "property double x\nproperty short quality\nproperty float y\n"
                             "property int z\nproperty uint8 red\nproperty uchar green\nproperty "
                             "uchar blue\n";
  const std::string face = "property int64 label\nproperty list short uint vertex_index\n"
                           "property list uchar double weights\nproperty char side\n";
  const auto content = [&](const auto& bytes, const char* format)
  {
    std::string text = Header(format, vertex, face, 3, 2);
    for (int i = 0; i < 3; ++i)
    {
      text += bytes(i == 1 ? 0.1 : 0.0) + bytes(static_cast<short>(-i)) +
        bytes(i == 2 ? 1.0F : 0.0F) + bytes(7) + std::string("\x01\x02\xff");
    }
    for (const unsigned int first : { 0U, 1U })
    {
      text +=
        bytes(static_cast<std::int64_t>(1) << (40 * first)) + bytes(static_cast<short>(2 + first));
      for (unsigned int k = 0; k < 2 + first; ++k)
      {
        text += bytes((first + k) % 3);
      }
      text += std::string(1, '\1') + bytes(0.5) + std::string(1, '\xfe');
    }
    return text;
  };
  for (const std::string& text :
    { content([](auto number) { return LittleEndian(number); }, "binary_little_endian"),
      content([](auto number) { return BigEndian(number); }, "binary_big_endian") })
  {
    const Reading reading = ReadText(text);
    EXPECT_EQ(reading.Messages, "");
    ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 2);
    EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 1 }));
    EXPECT_EQ(reading.Cell(1), (Ids{ 1, 2, 0 }));
    EXPECT_EQ(reading.Mesh->GetPoint(1)[0], 0.1) << "a double, to the last bit";
    EXPECT_EQ(reading.Mesh->GetPoint(2)[2], 7.0);
    EXPECT_EQ(reading.Point("quality", 2), (Values{ -2 }));
    EXPECT_EQ(reading.Point("Colors", 2), (Values{ 1, 2, 255, 255 }));
    EXPECT_EQ(reading.Face("label", 1), (Values{ 1099511627776.0 }));
    EXPECT_EQ(reading.Mesh->GetCellData()->GetArray("label")->GetDataTypeSize(), 8);
    EXPECT_EQ(reading.Face("side", 1), (Values{ -2 }));
    const std::size_t begin = text.find("end_header") + 11;
    for (std::size_t size = begin; size < text.size(); ++size)
    {
      ASSERT_TRUE(
        ReadText(text.substr(0, size)).Has(size < begin + 63 ? " of 3 vertices." : " of 2 faces."))
        << size - begin;
    }
  }
}

TEST(PLYReader, FurtherElementsColumnsAndFacesBeforeVertices)
{
  const Reading reading = ReadText(
    "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty float view\nproperty list int "
    "int "
    "ids\nelement face 1\nproperty list uchar int vertex_indices\nproperty float red\nproperty "
    "float "
    "green\nproperty float blue\nproperty float alpha\nelement vertex 3\n" +
    Coordinates +
    "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n"
    "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
    "0.5 2 7 8\n3 0 1 2 1 0.2 0 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0.5\n0 1 0 0 0 1 0 1\n0 1\n");
  EXPECT_EQ(reading.Messages, "");
  EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 2 }));
  EXPECT_EQ(reading.Face("Colors", 0), (Values{ 255, 51, 0, 0 }));
  EXPECT_EQ(reading.Point("Normals", 1), (Values{ 0, 0, 1 }));
  EXPECT_EQ(reading.Point("TextureCoordinates", 1), (Values{ 1, 0.5 }));
  EXPECT_NE(reading.Mesh->GetPointData()->GetNormals(), nullptr);
}

TEST(PLYReader, ElementsMayShareLinesOrGoOn)
{
  const Reading shared = ReadText(
    Header("ascii", Coordinates, Corners) + "0 0 0 1 0 0 1 1\n0 0 1 0 4 0 1 2 3 3 0 1\n2\n");
  EXPECT_EQ(shared.Messages, "");
  EXPECT_EQ(shared.Cell(1), (Ids{ 0, 1, 2 }));
  EXPECT_EQ(shared.Mesh->GetPoint(2)[1], 1.0);
}

TEST(PLYReader, StripsAreTriangles)
{
  const Reading reading = ReadText("ply\nformat ascii 1.0\nelement vertex 4\n" + Coordinates +
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + Square +
    "8 0 1 3 2 -1 1 2 3\n");
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 3);
  EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 3 }));
  EXPECT_EQ(reading.Cell(1), (Ids{ 3, 1, 2 })) << "turned the same way";
  EXPECT_EQ(reading.Cell(2), (Ids{ 1, 2, 3 }));
}

TEST(PLYReader, SaysWhatIsWrongAndWhere)
{
  const std::string good = Header("ascii", Coordinates, Corners);
  const std::pair<std::string, std::string> cases[] = {
    { "", "is not a valid PLY file: it is empty." },
    { "OFF\n", "it begins with \"OFF\" instead of ply." },
    { "ply\nformat ascii 1.0\nelement vertex 3\n", "its header has no end." },
    { "ply\nend_header\n", "its header does not say in which format it is." },
    { "ply\nformat xml 1.0\nend_header\n", "line 2 of its header cannot be understood" },
    { "ply\nformat ascii 1.0\nproperty float x\n", "line 3 of its header cannot be understood" },
    { "ply\nformat ascii 1.0\nelement vertex -1\n", "line 3 of its header cannot be understood" },
    { "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n", "line 4 of its header" },
    { "ply\nformat ascii 1.0\nend_header\n", "it has no element vertex." },
    { Header("ascii", "property float x\nproperty float y\n", Corners),
      "its vertices have no property z." },
    { Header("ascii", Coordinates, "") + Square, "its faces have no list of corners." },
    { Header("ascii", Coordinates, Corners, 4, 0) + Square, "holds no surface" },
    { "ply\nformat ascii 1.0\nelement face 1\nelement face 1\n", "line 4 of its header" },
    { good + "0 0 0\n1 0 0\n", "it ends after 2 of 4 vertices." },
    { good + Square + "3 0 1 2\n3 0 1\n", "it ends after 1 of 2 faces." },
    { good + Square + "3 0 1 2\n3 0 1 99999999999\n",
      "line 16 makes face 1 use vertex 2147483647" },
    { good + Square + "3 0 1 -2\n", "line 15 makes face 0 use vertex -1" },
    { good + Square + "3 0 1 2.5\n", "line 15 has no number that the property \"vertex_indices\"" },
    { good + "0 0 0\n1 none 0\n",
      "line 12 has no number that the property \"y\" of vertex 1 can have" },
    { good + "0 0 0 9 1 0 0 9\n1 1 0 9 0 1 0 9\n3 0 1 2 3 0 1 2\n", "line 11 has more numbers" },
    { Header("ascii", Coordinates, Corners, 2000000000) + Square, "it ends after 4 of 2000000000" },
    { "ply\nformat ascii 1.0\nelement vertex 99999999999\n" + Coordinates + "end_header\n",
      "more vertices than can be numbered" },
  };
  for (const auto& [text, message] : cases)
  {
    const Reading reading = ReadText(text);
    EXPECT_TRUE(reading.Has(message)) << "expected: " << message << "\nheard: " << reading.Messages;
    EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 0);
  }
}
