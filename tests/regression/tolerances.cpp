#include "tolerances.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <stdexcept>

namespace slope::testing {
namespace {

ColumnTolerance read_column(const std::string& name, const YAML::Node& node) {
  const Tolerance tolerance{node["absolute"].as<double>(0.0), node["relative"].as<double>(0.0)};
  if (!(tolerance.absolute > 0.0 || tolerance.relative > 0.0)) {
    throw std::runtime_error("\"" + name + "\" needs a tolerance: absolute, relative or both");
  }
  return {name, tolerance};
}

TableTolerances read_table(const YAML::Node& node) {
  TableTolerances table;
  if (const auto along = node["along"]) table.along = read_column(along["column"].as<std::string>(), along);
  for (const auto& entry : node["columns"]) {
    table.columns.push_back(read_column(entry.first.as<std::string>(), entry.second));
  }
  if (table.columns.empty()) throw std::runtime_error("a table has no columns to compare");
  return table;
}

}  // namespace

double Tolerance::at(double reference) const {
  return absolute + relative * std::abs(reference);
}

std::vector<std::string> TableTolerances::names() const {
  std::vector<std::string> names;
  if (along) names.push_back(along->column);
  for (const auto& column : columns) names.push_back(column.column);
  return names;
}

Tolerances read_tolerances(const std::filesystem::path& file) {
  try {
    const YAML::Node root = YAML::LoadFile(file.string());
    Tolerances tolerances;
    for (const auto& entry : root["tables"]) {
      tolerances.tables[entry.first.as<std::string>()] = read_table(entry.second);
    }
    tolerances.picture_threshold = root["pictures"]["threshold"].as<double>();
    tolerances.pictures = root["pictures"]["files"].as<std::vector<std::string>>();
    return tolerances;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

}  // namespace slope::testing
