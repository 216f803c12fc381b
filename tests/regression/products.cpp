#include "products.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "run_curves.hpp"
#include "run_folder.hpp"
#include "slope/couple/results.hpp"
#include "slope/testing/table.hpp"

namespace slope::testing {
namespace {

namespace fs = std::filesystem;

/// Columns of equal length under their names.
void write_table(const fs::path& file, const std::vector<std::string>& names,
                 const std::vector<std::vector<double>>& columns) {
  std::ofstream out(file);
  for (std::size_t c = 0; c < names.size(); ++c) out << (c == 0 ? "" : ",") << names[c];
  out << '\n';
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    // Adding zero turns a negative zero into a positive one.
    for (std::size_t c = 0; c < columns.size(); ++c) {
      out << (c == 0 ? "" : ",") << fmt::format("{:.6g}", columns[c][row] + 0.0);
    }
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

std::vector<std::vector<double>> history_columns(const fs::path& run, const std::vector<std::string>& names) {
  const Table history(run / "history.csv");
  std::vector<std::vector<double>> columns;
  for (const auto& name : names) columns.push_back(history.column(name));
  return columns;
}

/// The number at the end of a way, whose steps are keys or indices with dots between them.
double number_at(const couple::Document& summary, const std::string& way) {
  const couple::Document* at = &summary;
  std::istringstream steps(way);
  for (std::string step; at != nullptr && std::getline(steps, step, '.');) {
    at = at->kind == couple::Document::Kind::list ? &at->children.at(std::stoul(step)) : at->find(step);
  }
  if (at == nullptr || at->value.empty()) throw std::runtime_error("summary.json has no number at " + way);
  return std::stod(at->value);
}

std::vector<std::vector<double>> summary_columns(const fs::path& run, const std::vector<std::string>& names) {
  const couple::Document summary = couple::summary_document(couple::read_summary(run / "summary.json"));
  std::vector<std::vector<double>> columns;
  for (const auto& name : names) columns.push_back({number_at(summary, name)});
  return columns;
}

}  // namespace

void write_tables(const fs::path& run, const Tolerances& tolerances, const fs::path& folder) {
  tools::make_folder(folder);
  for (const auto& [file, table] : tolerances.tables) {
    const auto names = table.names();
    if (file == "history.csv") write_table(folder / file, names, history_columns(run, names));
    if (file == "summary.csv") write_table(folder / file, names, summary_columns(run, names));
  }
  tools::Losses losses;
  const auto profiles = tools::timed_profiles(tools::read_run_folder(run), losses);
  losses.throw_first();
  for (const auto& profile : profiles) {
    write_table(folder / fmt::format("profile_{:g}s.csv", profile.time), {"height [m]", "suction head [m]"},
                {profile.computed.height, profile.computed.head});
  }
}

}  // namespace slope::testing
