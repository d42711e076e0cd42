// SPDX-License-Identifier: BSD-3-Clause
#include "PlyFile.h"

#include "PlyHeader.h"
#include "PlySource.h"

#include <algorithm>
#include <limits>

namespace marrow
{
namespace
{
FileArray NewArray(const PlyProperty& property)
{
  FileArray array;
  array.Name = property.Name;
  switch (property.Type)
  {
    case PlyType::Int8:
      array.Values = std::vector<std::int8_t>();
      break;
    case PlyType::UInt8:
      array.Values = std::vector<std::uint8_t>();
      break;
    case PlyType::Int16:
      array.Values = std::vector<std::int16_t>();
      break;
    case PlyType::UInt16:
      array.Values = std::vector<std::uint16_t>();
      break;
    case PlyType::Int32:
      array.Values = std::vector<std::int32_t>();
      break;
    case PlyType::UInt32:
      array.Values = std::vector<std::uint32_t>();
      break;
    case PlyType::Int64:
      array.Values = std::vector<std::int64_t>();
      break;
    case PlyType::UInt64:
      array.Values = std::vector<std::uint64_t>();
      break;
    case PlyType::Float:
      array.Values = std::vector<float>();
      break;
    case PlyType::Double:
      array.Values = std::vector<double>();
      break;
  }
  return array;
}

/// "vertices" of "vertex", for messages.
std::string Plural(const std::string& element)
{
  return element == "vertex" ? "vertices" : element == "face" ? "faces" : element;
}

template <typename Source>
class PlyParser
{
public:
  PlyParser(std::string_view content, const PlyHeader& header, std::string_view fileName,
    FileMesh& mesh, const Progress& progress)
    : Header(header)
    , Numbers(content, header)
    , Name(fileName)
    , Result(mesh)
    , Watcher(progress)
  {
  }

  std::string Parse()
  {
    std::string error = this->FindVertices();
    for (const PlyElement& element : this->Header.Elements)
    {
      if (error.empty() && !this->Aborted)
      {
        error = this->ReadElement(element);
      }
    }
    if (error.empty() && !this->Aborted)
    {
      const std::string what = this->Numbers.EndError();
      error = what.empty() ? what : this->Error(what);
      JoinColumns(this->Result.PointArrays);
      JoinColumns(this->Result.FaceArrays);
    }
    return error;
  }

private:
  /// What becomes of a property.
  enum class Use
  {
    Coordinate,
    Column,
    Corners,
    Nothing
  };
  struct Target
  {
    Use Purpose = Use::Nothing;
    int Index = 0; ///< of the coordinate, or of the array
  };

  std::string Error(const std::string& what) const { return NotValid(this->Name, "PLY", what); }

  /// The faces may come first, but what they may name is known.
  std::string FindVertices()
  {
    const auto vertex = std::find_if(this->Header.Elements.begin(), this->Header.Elements.end(),
      [](const PlyElement& element) { return element.Name == "vertex"; });
    if (vertex == this->Header.Elements.end())
    {
      return this->Error("it has no element vertex");
    }
    for (const char* name : { "x", "y", "z" })
    {
      if (std::none_of(vertex->Properties.begin(), vertex->Properties.end(),
            [name](const PlyProperty& property)
            { return property.Name == name && !property.IsList; }))
      {
        return this->Error(std::string("its vertices have no property ") + name);
      }
    }
    if (vertex->Count > std::numeric_limits<int>::max())
    {
      return this->Error("it promises more vertices than can be numbered");
    }
    this->NumberOfVertices = vertex->Count;
    const auto face = std::find_if(this->Header.Elements.begin(), this->Header.Elements.end(),
      [](const PlyElement& element) { return element.Name == "face"; });
    this->HasFaces = face != this->Header.Elements.end();
    if (this->HasFaces && face->Count > 0 &&
      std::none_of(face->Properties.begin(), face->Properties.end(),
        [](const PlyProperty& property) { return property.IsList; }))
    {
      return this->Error("its faces have no list of corners");
    }
    return {};
  }

  /// Strips beside faces would say the same again.
  bool AreStrips(const PlyElement& element) const
  {
    return element.Name == "tristrips" && !this->HasFaces;
  }

  static bool IsCornerList(const PlyElement& element, const PlyProperty& property)
  {
    const auto isNamed = [](const PlyProperty& other)
    { return other.IsList && (other.Name == "vertex_indices" || other.Name == "vertex_index"); };
    const auto isList = [](const PlyProperty& other) { return other.IsList; };
    const auto& all = element.Properties;
    auto found = std::find_if(all.begin(), all.end(), isNamed);
    found = found == all.end() ? std::find_if(all.begin(), all.end(), isList) : found;
    return found != all.end() && &*found == &property;
  }

  /// Decides for every property of an element; arrays are added to the mesh.
  std::vector<Target> TargetsOf(const PlyElement& element)
  {
    const bool isVertex = element.Name == "vertex";
    const bool isFace = element.Name == "face";
    std::vector<FileArray>* arrays = isVertex ? &this->Result.PointArrays
      : isFace                                ? &this->Result.FaceArrays
                                              : nullptr;
    std::vector<Target> targets;
    for (const PlyProperty& property : element.Properties)
    {
      Target target;
      const bool isCoordinate =
        isVertex && property.Name.size() == 1 && property.Name[0] >= 'x' && property.Name[0] <= 'z';
      if (property.IsList)
      {
        const bool isCorners =
          (isFace || this->AreStrips(element)) && IsCornerList(element, property);
        target.Purpose = isCorners ? Use::Corners : Use::Nothing;
      }
      else if (isCoordinate)
      {
        target = { Use::Coordinate, property.Name[0] - 'x' };
      }
      else if (arrays)
      {
        target = { Use::Column, static_cast<int>(arrays->size()) };
        arrays->push_back(NewArray(property));
      }
      targets.push_back(target);
    }
    return targets;
  }

  std::string ReadElement(const PlyElement& element)
  {
    if (element.Properties.empty())
    {
      return {};
    }
    const std::vector<Target> targets = this->TargetsOf(element);
    const bool isVertex = element.Name == "vertex";
    const bool isFace = element.Name == "face";
    std::vector<FileArray>& arrays = isVertex ? this->Result.PointArrays : this->Result.FaceArrays;
    constexpr std::int64_t Interval = 1 << 14;
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      if (i % Interval == 0 && !Report(this->Watcher, this->Numbers.FractionRead()))
      {
        this->Aborted = true;
        return {};
      }
      this->Numbers.BeginRecord();
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (std::size_t p = 0; p < targets.size(); ++p)
      {
        const PlyProperty& property = element.Properties[p];
        PlyOutcome outcome = PlyOutcome::Good;
        if (property.IsList)
        {
          outcome = this->ReadList(property, targets[p].Purpose == Use::Corners);
        }
        else if (targets[p].Purpose == Use::Coordinate)
        {
          outcome = this->Numbers.Next(property.Type, point[targets[p].Index]);
        }
        else if (targets[p].Purpose == Use::Column)
        {
          outcome = this->ReadInto(arrays[targets[p].Index], property.Type);
        }
        else
        {
          double ignored = 0.0;
          outcome = this->Numbers.Next(property.Type, ignored);
        }
        if (outcome != PlyOutcome::Good)
        {
          return this->Describe(outcome, element, property, i);
        }
      }
      if (isVertex)
      {
        this->Result.Points.push_back(point);
      }
      else if (isFace)
      {
        const std::size_t begin = this->Result.FaceStarts.back();
        this->Result.EndFace();
        if (!this->AreVertices(begin))
        {
          return this->MissingVertex(begin, i);
        }
      }
    }
    return this->AreStrips(element) ? this->EndStrips() : std::string();
  }

  PlyOutcome ReadInto(FileArray& array, PlyType type)
  {
    return std::visit(
      [this, type](auto& values)
      {
        typename std::decay_t<decltype(values)>::value_type value{};
        const PlyOutcome outcome = this->Numbers.Next(type, value);
        values.push_back(value);
        return outcome;
      },
      array.Values);
  }

  PlyOutcome ReadList(const PlyProperty& property, bool isCorners)
  {
    std::int64_t count = 0;
    PlyOutcome outcome = this->Numbers.Next(property.CountType, count);
    if (outcome == PlyOutcome::Good && count < 0)
    {
      return PlyOutcome::Bad;
    }
    for (std::int64_t k = 0; k < count && outcome == PlyOutcome::Good; ++k)
    {
      if (isCorners)
      {
        std::int64_t corner = 0;
        outcome = this->Numbers.Next(property.Type, corner);
        // What no int holds is no vertex either; the check of the face says so.
        constexpr std::int64_t NoVertex = std::numeric_limits<int>::max();
        this->Result.Corners.push_back(
          static_cast<int>(std::clamp<std::int64_t>(corner, -1, NoVertex)));
      }
      else
      {
        double ignored = 0.0;
        outcome = this->Numbers.Next(property.Type, ignored);
      }
    }
    return outcome;
  }

  bool AreVertices(std::size_t begin) const
  {
    return std::all_of(this->Result.Corners.begin() + begin, this->Result.Corners.end(),
      [this](int corner) { return corner >= 0 && corner < this->NumberOfVertices; });
  }

  std::string MissingVertex(std::size_t begin, std::int64_t face) const
  {
    const auto missing =
      std::find_if(this->Result.Corners.begin() + begin, this->Result.Corners.end(),
        [this](int corner) { return corner < 0 || corner >= this->NumberOfVertices; });
    return this->Error(this->Numbers.Where() + " makes face " + std::to_string(face) +
      " use vertex " + std::to_string(*missing) + ", but the " +
      std::to_string(this->NumberOfVertices) + " vertices are numbered from 0");
  }

  /// Strips one after the other, parted by -1; every second triangle is the other way round.
  std::string EndStrips()
  {
    std::vector<int> strips;
    strips.swap(this->Result.Corners);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
      if (strips[i] < 0)
      {
        begin = i + 1;
        continue;
      }
      if (i < begin + 2)
      {
        continue;
      }
      const int turned = (i - begin) % 2 == 0 ? 0 : 1;
      const std::size_t start = this->Result.Corners.size();
      for (const int corner : { strips[i - 2 + turned], strips[i - 1 - turned], strips[i] })
      {
        this->Result.Corners.push_back(corner);
      }
      this->Result.EndFace();
      if (!this->AreVertices(start))
      {
        return this->MissingVertex(
          start, static_cast<std::int64_t>(this->Result.NumberOfFaces()) - 1);
      }
    }
    return {};
  }

  std::string Describe(PlyOutcome outcome, const PlyElement& element, const PlyProperty& property,
    std::int64_t index) const
  {
    if (outcome == PlyOutcome::End)
    {
      return this->Error("it ends after " + std::to_string(index) + " of " +
        std::to_string(element.Count) + " " + Plural(element.Name));
    }
    return this->Error(this->Numbers.Where() + " has no number that the property \"" +
      property.Name + "\" of " + element.Name + " " + std::to_string(index) + " can have");
  }

  const PlyHeader& Header;
  Source Numbers;
  std::string_view Name;
  FileMesh& Result;
  const Progress& Watcher;
  std::int64_t NumberOfVertices = 0;
  bool HasFaces = false;
  bool Aborted = false;
};
}

std::string ReadPlyFile(
  std::string_view content, std::string_view fileName, FileMesh& mesh, const Progress& progress)
{
  mesh = FileMesh();
  PlyHeader header;
  const std::string error = ReadPlyHeader(content, fileName, header);
  if (!error.empty())
  {
    return error;
  }
  return header.IsText ? PlyParser<PlyText>(content, header, fileName, mesh, progress).Parse()
                       : PlyParser<PlyBytes>(content, header, fileName, mesh, progress).Parse();
}
}
