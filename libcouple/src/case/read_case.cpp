#include "slope/couple/read_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "case_format.hpp"
#include "load_case.hpp"

namespace slope::couple {

namespace {

/// Overrides first, then file by file and line by line, then the tables that they name.
void sort_by_place(std::vector<Problem>& problems, const std::vector<std::string>& files) {
  const auto place = [&](const Problem& problem) {
    const auto file = std::find(files.begin(), files.end(), problem.file);
    return std::pair(problem.file == override_source ? 0 : file - files.begin() + 1, problem.line);
  };
  std::stable_sort(problems.begin(), problems.end(),
                   [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
}

/// Of many problems the first are told, and how many more there are.
void keep_first(std::vector<Problem>& problems) {
  constexpr std::size_t most_told = 100;
  if (problems.size() <= most_told) return;
  const std::size_t more = problems.size() - most_told;
  problems.resize(most_told);
  problems.push_back({"", 0, "", fmt::format("and {} more like these", more)});
}

/// The times of the figures need particle files too.
void add_figure_times(Case& input) {
  std::vector<double>& times = input.output.snapshots;
  times.insert(times.end(), input.figures.profile_times.begin(), input.figures.profile_times.end());
  times.insert(times.end(), input.figures.contour_times.begin(), input.figures.contour_times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

/// The format is large, and the same for every case.
const Format<Case>& format_of_cases() {
  static const Format<Case> format = case_format();
  return format;
}

}  // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides,
               std::vector<Problem>* warnings) {
  const std::string name = file.string();
  std::vector<Problem> problems;
  auto [document, files] = load_case(file, problems);
  for (const std::string& assignment : overrides) apply_override(document, assignment, problems);
  take_library_soils(document, file, files, problems);

  Case result;
  result.path = name;
  const Input root(document, name, problems, warnings);
  format_of_cases().read(root, result);
  if (!root.at("output").has("history_interval")) {
    result.output.history_interval = std::max(1.0, 1.0e-3 * result.stop.time);
  }
  if (document.kind == Document::Kind::map) check_case(root, result);
  if (warnings != nullptr) keep_first(*warnings);
  if (!problems.empty()) {
    sort_by_place(problems, files);
    keep_first(problems);
    throw InputError(std::move(problems));
  }
  add_figure_times(result);
  return result;
}

std::string resolved_yaml(const Case& input) {
  return yaml_text(format_of_cases().write(input));
}

std::string case_schema() {
  Document schema = Document::map();
  schema.set("$schema", Document::text("https://json-schema.org/draft/2020-12/schema"))
      .set("title", Document::text("slope case"))
      .set("description",
           Document::text("A case of slope-sim: rain-induced slope failure. Dimensional values carry their unit."));
  const Document& full = format_of_cases().schema;
  Document including = Document::map();
  including.set("required", Document::list({Document::text(include_key)}));
  schema.set("type", Document::text("object"))
      .set("if", std::move(including))
      .set("then", overlay_schema(full))
      .set("else", full);
  return json_text(schema);
}

}  // namespace slope::couple
