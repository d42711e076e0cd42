// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace marrow
{
namespace
{
namespace fs = std::filesystem;

/// The number of the system's error, or 0.
int WriteTo(const fs::path& path, const char* mode, std::string_view content)
{
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), mode);
  if (!file)
  {
    return errno != 0 ? errno : EIO;
  }
  const bool isWritten = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int error = isWritten ? 0 : errno;
  // A full disk may show only now.
  const bool isClosed = std::fclose(file) == 0;
  return isWritten && isClosed ? 0 : (error != 0 ? error : (errno != 0 ? errno : EIO));
}

/// A name in the same folder, and so on the same disk, that nobody has.
fs::path PlaceBeside(const fs::path& path)
{
  std::error_code ignored;
  fs::path beside;
  int number = 0;
  do
  {
    beside = path;
    beside += ".part" + std::to_string(number++);
  } while (fs::exists(beside, ignored));
  return beside;
}

int Write(const fs::path& path, std::string_view content)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    return WriteTo(path, "wb", content);
  }
  // Behind a symbolic link it is the file itself that is to be exchanged.
  const fs::path place = fs::exists(status) ? fs::canonical(path, error) : path;
  const fs::path beside = PlaceBeside(place);
  // x: never somebody else's file.
  int failure = WriteTo(beside, "wbx", content);
  if (failure == EACCES && fs::exists(status))
  {
    return WriteTo(place, "wb", content);
  }
  if (failure == 0 && fs::exists(status))
  {
    fs::permissions(beside, status.permissions(), error);
  }
  if (failure == 0)
  {
    fs::rename(beside, place, error);
    failure = error.value();
  }
  if (failure != 0)
  {
    fs::remove(beside, error);
  }
  return failure;
}
}

std::string WriteOutputFile(const std::string& fileName, std::string_view content)
{
  const int failure = Write(fileName, content);
  return failure == 0 ? std::string()
                      : "Cannot write \"" + fileName + "\": " + std::strerror(failure) +
      "; check the folder, its permissions and the space left.";
}
}
