// SPDX-License-Identifier: BSD-3-Clause
#include "FileContent.h"

#include <vtk_zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>

namespace marrow
{
namespace
{
std::string CannotRead(const std::string& fileName, const std::string& reason)
{
  return "Cannot read \"" + fileName + "\": " + reason;
}

/// Unpacks all members of a gzip file.
std::string Unpack(const std::string& fileName, const std::string& packed, std::string& content)
{
  constexpr int AnyWindowWithGzipHeader = 15 + 16;
  constexpr std::size_t SizeOfPiece = 1 << 18;
  z_stream stream{};
  if (inflateInit2(&stream, AnyWindowWithGzipHeader) != Z_OK)
  {
    return CannotRead(fileName, "there is not enough memory to unpack it.");
  }
  const std::unique_ptr<z_stream, decltype(&inflateEnd)> closing(&stream, inflateEnd);
  std::string piece(SizeOfPiece, '\0');
  std::size_t taken = 0;
  int state = Z_OK;
  while (state == Z_OK || (state == Z_STREAM_END && taken < packed.size()))
  {
    if (state == Z_STREAM_END && inflateReset(&stream) != Z_OK)
    {
      break;
    }
    const std::size_t left = packed.size() - taken;
    const auto given =
      static_cast<uInt>(std::min<std::size_t>(left, std::numeric_limits<uInt>::max()));
    // zlib promises not to write here.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
    stream.avail_in = given;
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    taken += given - stream.avail_in;
    content.append(piece, 0, piece.size() - stream.avail_out);
  }
  if (state == Z_BUF_ERROR)
  {
    return CannotRead(fileName,
      "the compressed data ends too early, after byte " + std::to_string(packed.size()) +
        "; copy the file anew.");
  }
  return state == Z_STREAM_END ? std::string()
                               : CannotRead(fileName,
                                   "the compressed data is damaged at byte " +
                                     std::to_string(taken) + "; copy the file anew.");
}
}

std::string ReadFileContent(const std::string& fileName, std::string& content)
{
  content.clear();
  std::error_code ignored;
  if (std::filesystem::is_directory(fileName, ignored))
  {
    return CannotRead(fileName, "it is a folder; name a file.");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(fileName.c_str(), "rb"), std::fclose);
  if (!file)
  {
    return CannotRead(
      fileName, std::string(std::strerror(errno)) + "; check the name and the permissions.");
  }
  const std::uintmax_t size = std::filesystem::file_size(fileName, ignored);
  constexpr std::size_t SizeOfPiece = 1 << 18;
  // What is no plain file has no size, or says 0, but can be read.
  std::size_t filled = 0;
  content.resize(ignored ? SizeOfPiece : static_cast<std::size_t>(size) + 1);
  while (true)
  {
    const std::size_t got =
      std::fread(content.data() + filled, 1, content.size() - filled, file.get());
    filled += got;
    if (filled < content.size())
    {
      break;
    }
    content.resize(content.size() + std::max(SizeOfPiece, content.size() / 2));
  }
  content.resize(filled);
  if (std::ferror(file.get()) != 0)
  {
    return CannotRead(fileName, std::string(std::strerror(errno)) + ".");
  }
  constexpr std::string_view GzipMark("\x1f\x8b");
  if (std::string_view(content).substr(0, GzipMark.size()) == GzipMark)
  {
    std::string packed;
    packed.swap(content);
    return Unpack(fileName, packed, content);
  }
  return {};
}
}
