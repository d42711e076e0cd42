// SPDX-License-Identifier: BSD-3-Clause
#include "ResultTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace marrow::bench
{
void ResultTable::Read(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line))
  {
    return;
  }
  if (line != this->Header())
  {
    throw std::runtime_error(path +
      ": the columns are those of another version of the benchmark; name a new folder or remove "
      "it.");
  }
  while (std::getline(file, line))
  {
    Result result;
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, result.Category, ',');
    std::getline(cells, cell, ',');
    result.Source = std::atoi(cell.c_str());
    std::getline(cells, cell, ',');
    result.Target = std::atoi(cell.c_str());
    bool complete = true;
    for (const std::string& column : this->Columns)
    {
      complete = std::getline(cells, cell, ',') && complete;
      if (!cell.empty())
      {
        result.Values[column] = std::strtod(cell.c_str(), nullptr);
      }
    }
    // The last cell always begins with a quote: a row without it was cut off.
    if (complete && std::getline(cells, result.Error) && result.Error.size() >= 2 &&
      result.Error.back() == '"')
    {
      result.Error = result.Error.substr(1, result.Error.size() - 2);
      this->Rows[{ result.Category, result.Source, result.Target }] = result;
    }
  }
}

void ResultTable::AppendTo(const std::string& path)
{
  const bool isNew = !std::filesystem::exists(path) || std::filesystem::file_size(path) == 0;
  this->File.open(path, std::ios::app);
  if (!this->File)
  {
    throw std::runtime_error(path + ": the file cannot be written.");
  }
  if (isNew)
  {
    this->File << this->Header() << std::endl;
  }
}

void ResultTable::Add(const Result& result)
{
  this->Rows[{ result.Category, result.Source, result.Target }] = result;
  this->File << this->Line(result) << std::endl;
}

void ResultTable::Write(const std::string& path) const
{
  std::ofstream file(path);
  file << this->Header() << "\n";
  for (const auto& [key, result] : this->Rows)
  {
    file << this->Line(result) << "\n";
  }
  if (!file)
  {
    throw std::runtime_error(path + ": the file cannot be written.");
  }
}

std::vector<Result> ResultTable::Results() const
{
  std::vector<Result> results;
  for (const auto& [key, result] : this->Rows)
  {
    results.push_back(result);
  }
  return results;
}

std::string ResultTable::Header() const
{
  std::string header = "category,source,target";
  for (const std::string& column : this->Columns)
  {
    header += "," + column;
  }
  return header + ",error";
}

std::string ResultTable::Line(const Result& result) const
{
  std::ostringstream line;
  line.precision(6);
  line << result.Category << "," << result.Source << "," << result.Target;
  for (const std::string& column : this->Columns)
  {
    line << ",";
    if (!std::isnan(result.Value(column)))
    {
      line << result.Value(column);
    }
  }
  std::string error = result.Error;
  std::replace(error.begin(), error.end(), '"', '\'');
  line << ",\"" << error << "\"";
  return line.str();
}
}
