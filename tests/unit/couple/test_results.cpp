#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <fstream>
#include <limits>
#include <regex>

#include "a_summary.hpp"
#include "case/input.hpp"
#include "schema_checker.hpp"
#include "slope/couple/water_amounts.hpp"

namespace slope::couple::test {
namespace {

Document parsed(const std::string& text) {
  std::vector<Problem> problems;
  Document document = parse_yaml(text, "text", problems, {"summary", "JSON", 20'000});
  EXPECT_TRUE(problems.empty()) << problems.front().text();
  return document;
}

/// As any other reader of JSON sees it, which is YAML.
YAML::Node seen(const RunSummary& run) {
  return YAML::Load(summary_json(run));
}

std::string violations_of(const RunSummary& run) {
  static const Document schema = parsed(summary_schema());
  std::string lines;
  for (const std::string& violation : schema_violations(schema, parsed(summary_json(run)))) lines += violation + '\n';
  return lines;
}

TEST(SummaryJson, HasTheValuesUnderKeysWithTheirUnits) {
  const YAML::Node json = seen(a_summary());
  EXPECT_EQ(json.begin()->first.as<std::string>(), "verdict") << "it comes first";
  EXPECT_EQ(json["verdict"].as<std::string>(), "fails");
  EXPECT_EQ(json["program"].as<std::string>(), "slope-sim");
  EXPECT_EQ(json["title"].as<std::string>(), a_summary().title);
  EXPECT_EQ(json["end"]["reason"].as<std::string>(), "displacement");
  EXPECT_EQ(json["end"]["time_s"].as<double>(), 890.5);
  EXPECT_FALSE(json["end"]["message"].IsDefined());
  EXPECT_EQ(json["onset"]["time_s"].as<double>(), 618.25);
  EXPECT_EQ(json["onset"]["criterion"].as<std::string>(), "displacement");
  EXPECT_EQ(json["onset"]["position_m"].as<std::vector<double>>(), (std::vector<double>{11.5, 5.75}));
  EXPECT_EQ(json["onset_by_runaway_s"].as<double>(), 590.5);
  EXPECT_EQ(json["displacement_times"][0]["time_s"].as<double>(), 618.25);
  EXPECT_TRUE(json["displacement_times"][1]["time_s"].IsNull());
  EXPECT_EQ(json["failure_zone"]["deviatoric_strain"].as<double>(), 0.02);
  EXPECT_EQ(json["failure_zone"]["at_onset"]["largest_suction_Pa"].as<double>(), 8000.0);
  EXPECT_TRUE(json["failure_zone"]["at_10_cm"].IsNull());
  EXPECT_EQ(json["failure_zone"]["at_end"]["area_m2"].as<double>(), 27.0);
  EXPECT_EQ(json["slide"]["displacement_m"].as<double>(), 0.02);
  EXPECT_EQ(json["slide"]["at_end"]["direction"].as<double>(), -1.0);
  EXPECT_EQ(json["slide"]["at_end"]["first_toe_m"].as<std::vector<double>>(), (std::vector<double>{10.0, 5.0}));
  EXPECT_FALSE(json["slide"]["at_end"]["reaches_wall"].as<bool>());
  EXPECT_EQ(json["water_budget"]["run_off_m3_per_m"].as<double>(), 1.0);
  EXPECT_EQ(json["water_budget"]["relative_balance_error"].as<double>(), 1e-9);
  EXPECT_EQ(json["water_budget"]["net_inflow_by_boundary_m3_per_m"]["outlet"].as<double>(), -0.25);
  EXPECT_TRUE(json["pressure_checkerboard"].IsNull()) << "JSON has no NaN";
  EXPECT_EQ(json["steps"].as<int>(), 46312);
  EXPECT_EQ(json["unsettled_pressure_steps"].as<int>(), 3);
  EXPECT_EQ(json["wall_time_s"].as<double>(), 61.5);
}

TEST(SummaryJson, OfASlopeThatStandsHasNoOnset) {
  RunSummary run = a_summary();
  run.found.onset_time.reset();
  run.found.slide_at_end.run_out.reset();
  run.found.slide_at_end.toe.reset();
  run.message = "stress is nan";
  const YAML::Node json = seen(run);
  EXPECT_TRUE(json["onset"].IsNull());
  EXPECT_EQ(json["onset_criterion_m"].as<double>(), 0.02);
  EXPECT_TRUE(json["slide"]["at_end"]["run_out_m"].IsNull());
  EXPECT_TRUE(json["slide"]["at_end"]["first_toe_m"].IsNull());
  EXPECT_EQ(json["end"]["message"].as<std::string>(), "stress is nan");
}

TEST(SummaryJson, HasEachOfTheWatersAmounts) {
  RunSummary run = a_summary();
  double value = 0.0;
  for (const WaterAmount& amount : water_amounts::all) run.found.water.*amount.value = value += 1.0;
  const YAML::Node water = seen(run)["water_budget"];
  std::vector<double> values;
  for (const auto& entry : water) {
    if (entry.second.IsScalar()) values.push_back(entry.second.as<double>());
  }
  EXPECT_EQ(values, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 1e-9}));
}

TEST(SummaryJson, GivesTheSameBytesWhenItIsReadAndWrittenAgain) {
  std::vector<RunSummary> runs{a_summary(), run_summary({}, {})};
  for (const auto& word : end_reasons) runs.push_back(a_summary()), runs.back().found.end_reason = word.value;
  for (const auto& word : verdicts) runs.push_back(a_summary()), runs.back().found.verdict = word.value;
  for (const auto& word : onset_criteria) runs.push_back(a_summary()), runs.back().onset_criterion = word.value;
  runs.push_back(a_summary());
  runs.back().found.onset_time.reset();
  runs.back().found.zone_at_10_cm = FailureZone{};
  runs.back().found.slide_at_10_cm = Slide{};
  runs.back().found.displacement_times.clear();
  runs.back().found.water.by_boundary.clear();
  runs.back().found.time = std::numeric_limits<double>::infinity();
  runs.back().found.largest_displacement = -0.0;
  runs.back().message = std::string(5000, 'x') + "\xff\x01\n";
  for (const RunSummary& run : runs) {
    const std::string text = summary_json(run);
    EXPECT_EQ(summary_json(summary_of(text, "summary.json")), text);
    EXPECT_EQ(violations_of(run), "");
  }
}

TEST(SummaryJson, IsReadBackWithAllThatItHolds) {
  RunSummary run = a_summary();
  run.found.pressure_checkerboard = 0.125;
  const RunSummary again = summary_of(summary_json(run), "summary.json");
  run.found.water.balance_error = again.found.water.balance_error;  // in the table of the books only
  EXPECT_TRUE(again.found == run.found);
  EXPECT_EQ(again.title, run.title);
  EXPECT_EQ(again.case_file, run.case_file);
  EXPECT_EQ(again.version, run.version);
  EXPECT_EQ(again.zone_strain, run.zone_strain);
  EXPECT_EQ(again.threads, run.threads);
  run.found.verdict = Verdict::does_not_stand;
  EXPECT_FALSE(summary_of(summary_json(run), "summary.json").found.stands_before);
}

TEST(SummaryJson, IsReadWithTheNamesThatItOnceHad) {
  std::string text = summary_json(a_summary());
  const auto replace = [&text](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace("relative_balance_error", "error");
  replace("\"criterion\": \"displacement\"", "\"criterion\": \"largest displacement above displacement_m\"");
  std::vector<Problem> not_understood;
  EXPECT_EQ(summary_json(summary_of(text, "summary.json", &not_understood)), summary_json(a_summary()));
  EXPECT_TRUE(not_understood.empty());
}

TEST(SummaryJson, OfAnotherVersionIsReadAsFarAsItIsKnown) {
  RunSummary run = a_summary();
  run.version = "99.1";
  std::string text = summary_json(run);
  const auto replace = [&text](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"verdict\": \"fails\"", "\"verdict\": \"creeps\"");
  replace("\"largest_displacement_m\"", "\"greatest_displacement_m\"");
  replace("\"at_end\": {", "\"at_end\": {\"width_m\": 7,");
  std::vector<Problem> not_understood;
  const RunSummary read = summary_of(text, "a/summary.json", &not_understood);
  EXPECT_EQ(read.found.verdict, Verdict::undecided);
  EXPECT_TRUE(std::isnan(read.found.largest_displacement));
  EXPECT_EQ(read.found.zone_at_end, run.found.zone_at_end);
  EXPECT_EQ(read.found.onset_time, run.found.onset_time);
  std::vector<std::string> lines;
  for (const Problem& problem : not_understood) lines.push_back(problem.text());
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0].find("a/summary.json:4: version: \"99.1\", and this program is "), 0u) << lines[0];
  EXPECT_EQ(lines[1].find("a/summary.json:2: verdict: unknown word \"creeps\"; choose one of: undecided"), 0u)
      << lines[1];
  EXPECT_NE(lines[2].find(": largest_displacement_m: missing"), std::string::npos) << lines[2];
  EXPECT_NE(lines[3].find(": failure_zone.at_end.width_m: unknown key"), std::string::npos) << lines[3];
  EXPECT_NE(lines[4].find(": greatest_displacement_m: unknown key, did you mean \"largest_displacement_m\"?"),
            std::string::npos)
      << lines[4];
}

/// Every key of a schema, with the schema of its value.
void visit_keys(const Document& schema, const std::string& path, const auto& visit) {
  if (const Document* items = schema.find("items")) visit_keys(*items, path + "[]", visit);
  const Document* properties = schema.find("properties");
  if (properties == nullptr) return;
  for (const Document& property : properties->children) {
    const std::string key = path.empty() ? property.key : path + '.' + property.key;
    visit(key, property);
    visit_keys(property, key, visit);
  }
}

bool has_numbers(const Document& schema) {
  const Document* type = schema.find("type");
  if (type == nullptr) return false;
  if (type->value == "object") {
    const Document* others = schema.find("additionalProperties");
    return others != nullptr && has_numbers(*others);
  }
  if (type->value == "integer") return true;
  if (const Document* items = schema.find("items")) return has_numbers(*items);
  return std::any_of(type->children.begin(), type->children.end(), [](const auto& t) { return t.value == "number"; });
}

TEST(SummarySchema, GivesEveryNumberItsUnitAndEveryKeyAMeaning) {
  const std::regex unit(R"((_m|_m2|_s|_Pa|_m3_per_m)$)");
  std::size_t numbers = 0;
  visit_keys(parsed(summary_schema()), "", [&](const std::string& key, const Document& schema) {
    const Document* meaning = schema.find("description");
    ASSERT_NE(meaning, nullptr) << key;
    EXPECT_FALSE(meaning->value.empty()) << key;
    if (!has_numbers(schema)) return;
    ++numbers;
    const bool ratio = meaning->value.ends_with(" (-)"), counted = schema.find("type")->value == "integer";
    EXPECT_TRUE(ratio || counted || std::regex_search(key, unit)) << key << ": " << meaning->value;
  });
  EXPECT_GT(numbers, 60u);
}

TEST(SummarySchema, RefusesWhatIsNotDescribed) {
  const Document schema = parsed(summary_schema());
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = summary_json(a_summary());
    text.replace(text.find(from), from.size(), to);
    return !schema_violations(schema, parsed(text)).empty();
  };
  EXPECT_FALSE(refused("fails", "stands"));
  EXPECT_TRUE(refused("fails", "falls"));
  EXPECT_TRUE(refused("\"time_s\": 890.5", "\"time_s\": \"late\""));
  EXPECT_TRUE(refused("\"time_s\": 890.5", "\"time_s\": 890.5, \"hour\": 1"));
  EXPECT_TRUE(refused("\"steps\": 46312", "\"steps\": 0.5"));
  EXPECT_TRUE(refused("\"slope-sim\"", "\"slope-render\""));
  EXPECT_TRUE(refused("\"threads\": 2,", ""));
  EXPECT_TRUE(refused("\"rain_m3_per_m\": 2.5,", ""));
}

TEST(WaterAmounts, AreExplainedInTheReadme) {
  std::ifstream stream(SLOPE_README);
  const std::string readme{std::istreambuf_iterator<char>(stream), {}};
  const auto expect_row = [&readme](const WaterAmount& amount) {
    std::string row = "| " + std::string(amount.name) + " | " + std::string(amount.unit) + " | ";
    row += std::string(amount.meaning) + " |\n";
    EXPECT_NE(readme.find(row), std::string::npos) << row;
  };
  for (const WaterAmount& amount : water_amounts::all) expect_row(amount);
  expect_row(water_amounts::balance_error);
  expect_row(water_amounts::relative_balance_error);
}

}  // namespace
}  // namespace slope::couple::test
