// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorObserver.h"
#include "TemporaryFile.h"
#include "TestMeshes.h"
#include "vtkMarrowSegmentReader.h"
#include "vtkMarrowSegmentWriter.h"

#include <vtkErrorCode.h>

using namespace marrow::test;

namespace
{
/// Eight triangles with the given cell array.
template <typename Value>
vtkSmartPointer<vtkPolyData> Octahedron(const char* name, const std::vector<Value>& values)
{
  auto mesh = ToPolyData(MakeSphere(1.0, 0));
  if constexpr (std::is_same_v<Value, int>)
  {
    marrow::SetIntArray(mesh->GetCellData(), name, values);
  }
  else
  {
    marrow::SetArray(mesh->GetCellData(), name, values);
  }
  return mesh;
}

std::string ReadErrors(vtkPolyData* mesh, const char* fileName)
{
  vtkNew<vtkMarrowSegmentReader> reader;
  const ErrorObserver errors(reader);
  reader->SetInputData(mesh);
  reader->SetFileName(fileName);
  reader->Update();
  return errors.Text();
}

const std::vector<int> Segments{ 0, 7, -3, 7, 2147483647, 0, 1, 1 };
}

TEST(SegmentFiles, WhatIsWrittenIsRead)
{
  const TemporaryFile file(".seg");
  vtkNew<vtkMarrowSegmentWriter> writer;
  writer->SetInputData(Octahedron("SegmentId", Segments));
  writer->SetFileName(file.Name());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(file.Text(), "0\n7\n-3\n7\n2147483647\n0\n1\n1\n");

  vtkNew<vtkMarrowSegmentReader> reader;
  reader->SetInputData(Octahedron("Other", Segments));
  reader->SetFileName(file.Name());
  reader->Update();
  std::vector<int> segments;
  vtkPolyData* output = reader->GetOutput();
  ASSERT_TRUE(marrow::GetArray(output->GetCellData(), "SegmentId", 8, segments));
  EXPECT_EQ(segments, Segments);
  EXPECT_EQ(output->GetCellData()->GetArray("SegmentId")->GetDataType(), VTK_INT);
  EXPECT_NE(output->GetCellData()->GetArray("Other"), nullptr) << "the mesh's arrays stay";
  EXPECT_EQ(output->GetNumberOfPoints(), 6);
}

TEST(SegmentFiles, AnyArrayOfIntegersCanBeWritten)
{
  const TemporaryFile file(".seg");
  vtkNew<vtkMarrowSegmentWriter> writer;
  writer->SetInputData(
    Octahedron("Pieces", std::vector<double>{ 1.0, 2.0, 3.0, 4.0, -5.0, 6.0, 7.0, 8.0 }));
  writer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Pieces");
  writer->SetFileName(file.Name());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(file.Text(), "1\n2\n3\n4\n-5\n6\n7\n8\n");
}

TEST(SegmentFiles, BlankLinesAndForeignLineEndsAreRead)
{
  const TemporaryFile file(".seg", "0\r\n1\r\n 2 \r\n3\r\n\r\n4\r\n5\r\n6\r\n7");
  EXPECT_EQ(ReadErrors(ToPolyData(MakeSphere(1.0, 0)), file.Name()), "");
}

TEST(SegmentFiles, ReaderSaysWhatIsWrongAndWhere)
{
  auto mesh = ToPolyData(MakeSphere(1.0, 0));
  const TemporaryFile few(".few", "0\n1\n2\n");
  EXPECT_NE(ReadErrors(mesh, few.Name())
              .find("has 3 segment numbers but the mesh has 8 cells: use "
                    "the file that belongs to this mesh."),
    std::string::npos);
  const TemporaryFile many(".many", "0\n1\n2\n3\n4\n5\n6\n7\n8\n");
  EXPECT_NE(ReadErrors(mesh, many.Name()).find("has 9 segment numbers but the mesh has 8 cells"),
    std::string::npos);
  for (const char* line : { "1.5", "one", "1 2", "99999999999" })
  {
    const TemporaryFile bad(".bad", std::string("0\n\n") + line + "\n3\n4\n5\n6\n7\n8\n");
    EXPECT_NE(ReadErrors(mesh, bad.Name()).find("Line 3 of"), std::string::npos) << line;
    EXPECT_NE(ReadErrors(mesh, bad.Name()).find("is not one integer"), std::string::npos) << line;
  }
  EXPECT_NE(
    ReadErrors(mesh, "/nowhere.seg").find("Cannot read \"/nowhere.seg\""), std::string::npos);
  EXPECT_NE(ReadErrors(mesh, nullptr).find("There is no file name"), std::string::npos);
}

TEST(SegmentFiles, WriterSaysWhatIsWrong)
{
  const TemporaryFile file(".seg");
  vtkNew<vtkMarrowSegmentWriter> writer;
  ErrorObserver errors(writer);
  writer->SetInputData(Octahedron("Pieces", Segments));
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_TRUE(errors.HasError("There is no file name: set FileName.")) << errors.Text();
  EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::NoFileNameError);

  writer->SetFileName(file.Name());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_TRUE(errors.HasError("The mesh has no cell array \"SegmentId\": choose the array"))
    << errors.Text();

  writer->SetInputData(Octahedron("SegmentId", std::vector<double>{ 1, 2, 3, 4, 5.5, 6, 7, 8 }));
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_TRUE(errors.HasError("is no integer at cell 4 but 5.5")) << errors.Text();

  writer->SetInputData(Octahedron("SegmentId", Segments));
  writer->SetFileName("/nowhere/at/all.seg");
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_TRUE(errors.HasError("Cannot write \"/nowhere/at/all.seg\": No such file or directory"))
    << errors.Text();

  writer->SetFileName(file.Name());
  EXPECT_EQ(writer->Write(), 1) << "an earlier error does not stick";
}
