// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReading.h"

#include <vtk_zlib.h>

using marrow::test::Read;
using marrow::test::Reading;
using marrow::test::ReadText;
using marrow::test::TemporaryFile;

namespace
{
const std::string Triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string Packed(const std::string& text)
{
  const TemporaryFile file(".gz");
  gzFile stream = gzopen(file.Name(), "wb");
  EXPECT_EQ(gzwrite(stream, text.data(), static_cast<unsigned int>(text.size())),
    static_cast<int>(text.size()));
  gzclose(stream);
  return file.Text();
}
}

TEST(CompressedFiles, AreReadInOneOrSeveralMembersWhateverTheirName)
{
  for (const std::string& packed :
    { Packed(Triangle), Packed(Triangle.substr(0, 9)) + Packed(Triangle.substr(9)) })
  {
    for (const char* ending : { ".off.gz", ".OFF.GZ", ".off" })
    {
      const Reading reading = ReadText(ending, packed);
      EXPECT_EQ(reading.Messages, "");
      EXPECT_EQ(reading.Mesh->GetNumberOfPolys(), 1) << ending;
    }
  }
}

TEST(CompressedFiles, DefectsAreNamed)
{
  const std::string packed = Packed(Triangle);
  EXPECT_TRUE(
    ReadText(".off.gz", packed.substr(0, packed.size() - 4)).Has("ends too early, after byte"));
  EXPECT_TRUE(ReadText(".off.gz", packed.substr(0, 15)).Has("ends too early, after byte 15"));
  std::string damaged = packed;
  damaged[12] = '\xff';
  EXPECT_TRUE(ReadText(".off.gz", damaged).Has("is damaged at byte"));
  EXPECT_TRUE(ReadText(".vtp.gz", packed).Has("must end in .off"));
}
