#include "slope/couple/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "results/summary_format.hpp"

namespace slope::couple {

namespace {

constexpr std::size_t most_bytes = 10'000'000;
constexpr std::size_t longest_text = 20'000;  // of messages with long paths (bytes)
constexpr std::size_t most_told = 20;

/// Whether a table has every value of its enum, at its place.
template <class E, std::size_t size>
consteval bool in_order(const std::array<Word<E>, size>& words) {
  for (std::size_t i = 0; i < size; ++i) {
    if (static_cast<std::size_t>(words[i].value) != i) return false;
  }
  return true;
}
static_assert(in_order(end_reasons) && end_reasons.back().value == EndReason::error);
static_assert(in_order(verdicts) && verdicts.back().value == Verdict::water_alone);

const ResultFormat<RunSummary>& format_of_summaries() {
  static const ResultFormat<RunSummary> format = summary_format();
  return format;
}

[[noreturn]] void refuse(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += (text.empty() ? "" : "\n") + problem.text();
  throw FileError(text);
}

void keep_first(std::vector<Problem>& problems, const std::string& file) {
  if (problems.size() <= most_told) return;
  const std::size_t more = problems.size() - most_told;
  problems.resize(most_told);
  problems.push_back({file, 0, "", fmt::format("and {} more like these", more)});
}

/// Refuses what another program wrote.
void require_summary(const Document& document, const std::string& name) {
  const auto expected = fmt::format("expected \"{}\": is not a summary of it", summary_program);
  if (document.kind != Document::Kind::map)
    refuse({{name, document.line, "", "is not a summary: expected a map of keys"}});
  const Document* program = document.find("program");
  if (program == nullptr) refuse({{name, 0, "program", "missing, " + expected}});
  if (program->value != summary_program) refuse({{name, program->line, "program", expected}});
  if (document.find("version") == nullptr) refuse({{name, 0, "version", "missing, expected that of the program"}});
}

}  // namespace

std::string_view text_of(EndReason reason) {
  return end_reasons.at(static_cast<std::size_t>(reason)).text;
}

std::string_view text_of(Verdict verdict) {
  return verdicts.at(static_cast<std::size_t>(verdict)).text;
}

bool is_complete(EndReason reason) {
  switch (reason) {
    case EndReason::time:
    case EndReason::displacement:
    case EndReason::after_onset:
    case EndReason::at_rest:
      return true;
    case EndReason::running:
    case EndReason::interrupted:
    case EndReason::error:
      break;
  }
  return false;
}

RunSummary run_summary(const Case& input, Summary found) {
  RunSummary run;
  run.found = std::move(found);
  run.version = SLOPE_VERSION;
  run.title = input.title;
  run.case_file = input.path;
  run.onset_criterion = input.onset;
  run.zone_strain = input.failure_zone_strain;
  return run;
}

Document summary_document(const RunSummary& summary) {
  return format_of_summaries().write(summary);
}

std::string summary_json(const RunSummary& summary) {
  return json_text(summary_document(summary));
}

std::string summary_schema() {
  Document schema = Document::map();
  schema.set("$schema", Document::text("https://json-schema.org/draft/2020-12/schema"))
      .set("title", Document::text("slope summary"))
      .set("description",
           Document::text("What slope-sim found: summary.json. SI units, named in the keys; (-): a ratio. "
                          "null: it did not happen, or is no number."));
  for (const Document& keyword : format_of_summaries().schema.children) schema.set(keyword.key, keyword);
  return json_text(schema);
}

RunSummary summary_of(const std::string& text, const std::string& name, std::vector<Problem>* not_understood) {
  std::vector<Problem> problems, unknown;
  const Document document = parse_yaml(text, name, problems, {"summary", "JSON", longest_text});  // JSON is YAML
  if (!problems.empty()) refuse(problems);
  require_summary(document, name);
  RunSummary summary;
  format_of_summaries().read(Input(document, name, problems, &unknown), summary);
  if (summary.version == SLOPE_VERSION) problems.insert(problems.end(), unknown.begin(), unknown.end());
  keep_first(problems, name);
  if (!problems.empty()) refuse(problems);
  summary.found.stands_before = summary.found.verdict != Verdict::does_not_stand;
  if (not_understood == nullptr) return summary;
  keep_first(unknown, name);
  if (!unknown.empty()) {
    unknown.insert(unknown.begin(), {name, document.find("version")->line, "version",
                                     fmt::format("\"{}\", and this program is {}; what it does not understand:",
                                                 shortened(summary.version), SLOPE_VERSION)});
  }
  *not_understood = std::move(unknown);
  return summary;
}

RunSummary read_summary(const std::filesystem::path& file, std::vector<Problem>* not_understood) {
  return summary_of(read_text_file(file, most_bytes), file.string(), not_understood);
}

}  // namespace slope::couple
