// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReading.h"
#include "vtkMarrowSegmentSelector.h"

#include <vtkFieldData.h>
#include <vtkStringArray.h>

using marrow::test::ErrorObserver;
using marrow::test::Reading;
using marrow::test::ReadText;

namespace
{
struct Selection
{
  std::vector<int> Segments;
  std::vector<std::string> Names;
  std::string Messages;

  bool Has(const std::string& part) const { return this->Messages.find(part) != std::string::npos; }
};

Selection Select(vtkPolyData* mesh, const char* labels)
{
  vtkNew<vtkMarrowSegmentSelector> selector;
  const ErrorObserver errors(selector);
  selector->SetInputData(mesh);
  selector->SetLabels(labels);
  selector->Update();
  Selection selection;
  selection.Messages = errors.Text();
  vtkPolyData* output = selector->GetOutput();
  if (vtkDataArray* array = output->GetCellData()->GetArray("SegmentId"))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      selection.Segments.push_back(static_cast<int>(array->GetTuple1(i)));
    }
    EXPECT_EQ(output->GetCellData()->GetScalars(), array);
  }
  if (auto* names =
        vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("SegmentName")))
  {
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    {
      selection.Names.push_back(names->GetValue(i));
    }
  }
  return selection;
}

/// Two triangles with a property of their own, and one of their points.
Reading Triangles(const std::string& type, const std::string& first, const std::string& second)
{
  return ReadText(".ply",
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\nproperty uchar part\nelement face 2\nproperty list uchar int vertex_indices\nproperty " +
      type + " label\nend_header\n0 0 0 7\n1 0 0 5\n1 1 0 5\n0 1 0 9\n3 0 1 2 " + first +
      "\n3 0 2 3 " + second + "\n");
}

using Ints = std::vector<int>;
using Strings = std::vector<std::string>;
}

TEST(SegmentSelector, WholeNumbersOfAnyType)
{
  for (const std::string type :
    { "char", "uchar", "short", "int", "uint", "int64", "uint64", "float", "double" })
  {
    EXPECT_EQ(Select(Triangles(type, "3", "7").Mesh, "label").Segments, (Ints{ 3, 7 })) << type;
  }
  EXPECT_EQ(Select(Triangles("int64", "-2147483648", "2147483647").Mesh, "label").Segments,
    (Ints{ -2147483647 - 1, 2147483647 }));
}

TEST(SegmentSelector, NumbersThatAreNoLabels)
{
  const char* range = "beyond the range from -2147483648 to 2147483647";
  EXPECT_TRUE(Select(Triangles("int64", "1", "2147483648").Mesh, "label")
                .Has("the array \"label\" of segments is 2147483648 at cell 1, beyond the range"));
  for (const auto& [type, number] :
    { std::pair<const char*, const char*>{ "int64", "-9223372036854775808" },
      { "uint", "4294967295" }, { "double", "1e300" }, { "float", "2147483648" } })
  {
    EXPECT_TRUE(Select(Triangles(type, "1", number).Mesh, "label").Has(range)) << type;
  }
  EXPECT_TRUE(
    Select(Triangles("double", "0.5", "1").Mesh, "label").Has("no integer at cell 0 but 0.5"));
  EXPECT_TRUE(Select(Triangles("float", "1", "nan").Mesh, "label").Has("is no integer at cell 1"));
}

TEST(SegmentSelector, PointsVoteForTheirCells)
{
  EXPECT_EQ(Select(Triangles("int", "0", "0").Mesh, "part").Segments, (Ints{ 5, 5 }))
    << "the most frequent; of three as frequent the least";
}

TEST(SegmentSelector, MissingLabelsAreAnsweredByThoseThereAre)
{
  EXPECT_TRUE(Select(Triangles("int", "0", "0").Mesh, "SegmentId")
                .Has("the mesh has no labels \"SegmentId\"; it has \"label\", \"part\": choose"));
  const Reading plain = ReadText(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_TRUE(Select(plain.Mesh, "groups").Has("nor others: name a .seg file"));
  const Reading parts = ReadText(".obj", "v 0 0 0 1 0 0\ng a\nusemtl b\no c\nf 1 1 1\n");
  EXPECT_TRUE(Select(parts.Mesh, "")
                .Has("it has \"groups\", \"objects\", \"materials\", \"colors\": choose"));
}

TEST(SegmentSelector, PartsOfAFileKeepTheirNames)
{
  const Reading reading = ReadText(
    ".obj", "v 0 0 0\ng tail\nf 1 1 1\nusemtl fur\ng head\no a2\nf 1 1 1\no a4\nf 1 1 1\n");
  const Selection groups = Select(reading.Mesh, "groups");
  EXPECT_EQ(groups.Segments, (Ints{ 1, 0, 0 }));
  EXPECT_EQ(groups.Names, (Strings{ "head", "tail" }));
  EXPECT_EQ(Select(reading.Mesh, "materials").Names, (Strings{ "", "fur" }));
  EXPECT_EQ(Select(reading.Mesh, "objects").Segments, (Ints{ 0, 1, 2 })) << "one has no name";
  const Reading written =
    ReadText(".obj", "v 0 0 0\ng segment_-2\nf 1 1 1\ng segment_70000\nf 1 1 1\n");
  EXPECT_EQ(Select(written.Mesh, "groups").Segments, (Ints{ -2, 70000 }));
  EXPECT_EQ(Select(written.Mesh, "groups").Names, Strings());
}

TEST(SegmentSelector, EqualColorsAreOneSegment)
{
  const std::string square = "4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const Selection any =
    Select(ReadText(".off",
             "OFF\n" + square + "3 0 1 2 9 0 0\n3 0 1 2 1 0 2\n3 0 1 2 9 0 0\n3 0 1 2 1 0 2 9\n")
             .Mesh,
      "colors");
  EXPECT_EQ(any.Segments, (Ints{ 2, 1, 2, 0 }));
  EXPECT_EQ(any.Names, (Strings{ "#01000209", "#010002", "#090000" }));
  // Orange and sky blue: the colours of the labels 1 and 2.
  const Selection known =
    Select(ReadText(".off",
             "OFF\n" + square +
               "3 0 1 2 86 180 233\n3 0 1 2 230 159 0\n3 0 1 2 204 204 204\n3 0 1 2 86 180 233\n")
             .Mesh,
      "colors");
  EXPECT_EQ(known.Segments, (Ints{ 2, 1, -1, 2 }));
  EXPECT_EQ(known.Names, Strings());
  const Selection points =
    Select(ReadText(".off", "COFF\n3 1 0\n0 0 0 9 9 9\n1 0 0 1 1 1\n0 1 0 9 9 9\n3 0 1 2\n").Mesh,
      "colors");
  EXPECT_EQ(points.Segments, (Ints{ 1 }));
}
