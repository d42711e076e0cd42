// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TemporaryFile_h
#define marrow_TemporaryFile_h

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace marrow::test
{
/// A file of its own for the running test, removed with the object.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& suffix)
  {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    this->Path =
      ::testing::TempDir() + "marrow_" + test->test_suite_name() + "_" + test->name() + suffix;
  }
  TemporaryFile(const std::string& suffix, const std::string& text)
    : TemporaryFile(suffix)
  {
    std::ofstream(this->Path, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::remove(this->Path.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const char* Name() const { return this->Path.c_str(); }
  std::string Text() const
  {
    std::ostringstream text;
    text << std::ifstream(this->Path, std::ios::binary).rdbuf();
    return text.str();
  }

private:
  std::string Path;
};
}

#endif
