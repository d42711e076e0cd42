// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceFigures.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>

namespace marrow::bench
{
ReferenceFigures ReadReferenceFigures(const std::string& path)
{
  constexpr const char* peers[] = { "humans_rand_error", "rigid_rand_error",
    "rigid_label_accuracy" };
  ReferenceFigures figures;
  try
  {
    std::ifstream file(path);
    const nlohmann::json json = nlohmann::json::parse(file);
    for (const char* peer : peers)
    {
      figures.Peers[peer] = json.at(peer).get<std::map<std::string, double>>();
    }
    for (const nlohmann::json& entry : json.at("groups"))
    {
      CategoryGroup group;
      group.Name = entry.at("name").get<std::string>();
      group.Categories = entry.at("categories").get<std::set<std::string>>();
      group.Bars = entry.at("bars").get<std::map<std::string, double>>();
      for (const char* peer : peers)
      {
        if (entry.contains(peer))
        {
          group.Peers[peer] = entry.at(peer).get<double>();
        }
      }
      figures.Groups.push_back(group);
    }
    for (const auto& [category, entry] : json.at("extremities").items())
    {
      figures.ExtremitiesOf[category] = { entry.at("labels").get<std::set<std::string>>(),
        entry.at("natural").get<std::set<std::string>>() };
    }
  }
  catch (const nlohmann::json::exception& error)
  {
    throw std::runtime_error(path + ": " + error.what());
  }
  return figures;
}
}
