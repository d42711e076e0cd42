// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FileMesh_h
#define marrow_FileMesh_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

namespace marrow
{
/// Numbers of a file, one tuple per point or per face, in the type that the file has.
struct FileArray
{
  using Data = std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>,
    std::vector<std::int16_t>, std::vector<std::uint16_t>, std::vector<std::int32_t>,
    std::vector<std::uint32_t>, std::vector<std::int64_t>, std::vector<std::uint64_t>,
    std::vector<float>, std::vector<double>>;

  std::string Name;
  Data Values;
  int Components = 1;

  std::size_t NumberOfTuples() const;
  std::vector<double> AsDoubles() const;
};

/// The parts that a file's faces belong to, such as its groups: those of one name are one.
class FileParts
{
public:
  /// The faces from here on belong to the part of that name.
  void Begin(const std::string& name);
  void AddFace();

  /// Whether any part has a name.
  bool HasNames() const { return this->Names.size() > this->Numbers.count(""); }
  /// Of each face, an index to NameOfPart.
  const std::vector<int>& PartOfFace() const { return this->Ids; }
  const std::vector<std::string>& NameOfPart() const { return this->Names; }

private:
  std::vector<int> Ids;
  std::vector<std::string> Names;
  std::unordered_map<std::string, int> Numbers;
  int Current = -1;
};

/// A surface as a file holds it: every face in the file's order, with any number of corners.
struct FileMesh
{
  std::vector<Eigen::Vector3d> Points;
  std::vector<int> Corners;                    ///< of all faces, one after the other
  std::vector<std::size_t> FaceStarts = { 0 }; ///< where each face's corners begin, and the end
  std::vector<FileArray> PointArrays;
  std::vector<FileArray> FaceArrays;
  FileParts Groups;
  FileParts Objects;
  FileParts Materials;

  std::size_t NumberOfFaces() const { return this->FaceStarts.size() - 1; }
  /// Makes the corners that were added since the last one a face.
  void EndFace() { this->FaceStarts.push_back(this->Corners.size()); }
};

using FileColor = std::array<unsigned char, 4>; ///< red, green, blue and opacity

/// What an array of RGBA colours, of unit normals and of texture coordinates is called.
inline constexpr const char* ColorsName = "Colors";
inline constexpr const char* NormalsName = "Normals";
inline constexpr const char* TextureCoordinatesName = "TextureCoordinates";

/// 0 to 255, whatever the number.
unsigned char ColorComponent(double value);

FileArray ColorArray(const std::vector<FileColor>& colors);

/// Joins columns that belong together: red, green, blue and, if there is one, alpha to Colors; nx, ny,
/// nz to Normals; s and t, u and v, or texture_u and texture_v to TextureCoordinates.
void JoinColumns(std::vector<FileArray>& arrays);

/// One sentence on a file that is not what its name says.
std::string NotValid(std::string_view fileName, const char* format, const std::string& what);
}

#endif
