#include "slope/couple/read_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "case_format.hpp"

namespace slope::couple {

namespace {

std::string content_of(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw FileError(fmt::format("{}: is a folder, not a case file", file.string()));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  if (stream && stream.peek() != std::ifstream::traits_type::eof()) content << stream.rdbuf();
  if (!stream.is_open() || stream.bad())
    throw FileError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  return content.str();
}

/// The times of the figures need particle files too.
void add_figure_times(Case& input) {
  std::vector<double>& times = input.output.snapshots;
  times.insert(times.end(), input.figures.profile_times.begin(), input.figures.profile_times.end());
  times.insert(times.end(), input.figures.contour_times.begin(), input.figures.contour_times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

}  // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const std::string name = file.string();
  std::vector<Problem> problems;
  Document document = parse_yaml(content_of(file), name, problems);
  if (document.kind == Document::Kind::empty && !problems.empty()) throw InputError(std::move(problems));
  for (const std::string& assignment : overrides) apply_override(document, assignment, problems);

  Case result;
  result.path = name;
  const Input root(document, name, problems);
  case_format().read(root, result);
  if (document.kind == Document::Kind::map) check_case(root, result);
  if (!problems.empty()) {
    std::stable_sort(problems.begin(), problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    throw InputError(std::move(problems));
  }
  add_figure_times(result);
  return result;
}

std::string resolved_yaml(const Case& input) {
  return yaml_text(case_format().write(input));
}

std::string case_schema() {
  Document schema = Document::map();
  schema.set("$schema", Document::text("https://json-schema.org/draft/2020-12/schema"))
      .set("title", Document::text("slope case"))
      .set("description",
           Document::text("A case of slope-sim: rain-induced slope failure. Dimensional values carry their unit."));
  for (const Document& entry : case_format().schema.children) schema.set(entry.key, entry);
  return json_text(schema);
}

}  // namespace slope::couple
