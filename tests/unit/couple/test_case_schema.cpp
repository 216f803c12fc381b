#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "case/input.hpp"
#include "case_folder.hpp"
#include "schema_checker.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

Document parsed(const std::string& text) {
  std::vector<Problem> problems;
  Document document = parse_yaml(text, "text", problems);
  EXPECT_TRUE(problems.empty());
  return document;
}

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

class CaseSchema : public testing::Test {
 protected:
  const Document schema_ = parsed(case_schema());
  const Document& whole_ = *schema_.find("else");  ///< of a case that includes no other
};

TEST_F(CaseSchema, IsDraft202012) {
  EXPECT_EQ(schema_.find("$schema")->value, "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema_.find("type")->value, "object");
}

TEST_F(CaseSchema, HoldsForTheShippedCasesAsWrittenAndResolved) {
  ASSERT_FALSE(shipped_case_files().empty());
  for (const auto& file : shipped_case_files()) {
    EXPECT_EQ(joined_lines(schema_violations(schema_, parsed(content_of(file)))), "") << file;
    EXPECT_EQ(joined_lines(schema_violations(schema_, parsed(resolved_yaml(read_case(file))))), "") << file;
  }
}

TEST_F(CaseSchema, RefusesWhatTheReaderRefuses) {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"porosity: 0.35", "porosity: -0.35"},
      {"porosity: 0.35", "porosity: 0.35 m"},
      {"youngs_modulus: 10 MPa", "youngs_modulus: 10"},
      {"grain_density: 2700 kg/m3", "grain_density: 27 kN/m3"},
      {"cohesion: 1 kPa", "cohesoin: 1 kPa"},
      {"    porosity: 0.35\n", ""},
      {"n: 3\n", "n: 1\n"},
      {"left: roller", "left: rollers"},
      {"model: hillel", "model: corey"},
      {"pressure: 0 kPa,", ""},
      {"pressure: 0 kPa,", "pressure: 0 kPa, flux: 1 mm/h,"},
      {"pressure: 0 kPa,", "rain: {intensity: 1 mm/h, file: storm.csv},"},
      {"name: rain", "name: 1 rain"},
      {"particles_per_cell: 4", "particles_per_cell: 5"},
      {"lower: [0 m, 0 m]", "lower: [0 m]"},
      {"A1: [10.9 m", "A 1: [10.9 m"},
  };
  for (const auto& [text, replacement] : mistakes) {
    const std::string content = slope_with(text, replacement).content;
    EXPECT_FALSE(schema_violations(schema_, parsed(content)).empty()) << replacement;
  }
}

/// The keys that a schema names for this document: of its properties, or of the branch that has its model or type.
std::set<std::string> keys_of(const Document& schema, const Document& document) {
  std::set<std::string> keys;
  const auto add = [&keys](const Document& object) {
    for (const Document& property : object.find("properties")->children) keys.insert(property.key);
  };
  if (schema.find("properties") != nullptr) {
    add(schema);
    return keys;
  }
  for (const Document& branch : schema.find("oneOf")->children) {
    for (const char* word : {"model", "type"}) {
      const Document* chosen = document.find(word);
      const Document* property = branch.find("properties")->find(word);
      if (chosen != nullptr && property != nullptr && property->find("const")->value == chosen->value) add(branch);
    }
  }
  return keys;
}

/// The schema of an entry of this document.
const Document* schema_of_entry(const Document& schema, const Document& document, const Document& entry) {
  if (const Document* items = schema.find("items")) return items;
  if (const Document* properties = schema.find("properties")) return properties->find(entry.key);
  if (const Document* others = schema.find("additionalProperties")) return others;
  if (const Document* alternatives = schema.find("anyOf")) {
    const auto list = std::ranges::find_if(alternatives->children,
                                           [](const Document& branch) { return branch.find("items") != nullptr; });
    return list != alternatives->children.end() ? list->find("items") : nullptr;
  }
  for (const Document& branch : schema.find("oneOf")->children) {
    if (schema_violations(branch, document).empty()) return branch.find("properties")->find(entry.key);
  }
  return nullptr;
}

/// The keys that the reader lists when it meets one that it cannot know.
std::set<std::string> keys_the_reader_lists(const std::filesystem::path& file, const std::string& path) {
  const std::string bogus = joined_key(path, "zzzzzzzz");
  try {
    (void)read_case(file, {bogus + "=1"});
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) {
      const std::string start = "unknown key; choose one of: ";
      if (problem.key != bogus || !problem.message.starts_with(start)) continue;
      std::set<std::string> keys;
      std::string word;
      for (const char c : problem.message.substr(start.size()) + ",") {
        if (c == ',') {
          keys.insert(word);
          word.clear();
        } else if (c != ' ') {
          word += c;
        }
      }
      return keys;
    }
  }
  return {};
}

/// By what problems call an entry: its key, the name of a list item, or else its number.
std::string word_for(const Document& entry, std::size_t number) {
  if (!entry.key.empty()) return entry.key;
  const Document* name = entry.find("name");
  return name != nullptr ? name->value : std::to_string(number);
}

/// The schema that conditions leave for a document.
const Document& branch_for(const Document& document, const Document& schema) {
  const Document* condition = schema.find("if");
  if (condition == nullptr) return schema;
  const bool holds = schema_violations(*condition, document).empty();
  return branch_for(document, *schema.find(holds ? "then" : "else"));
}

/// Compares, for every map of the document, what schema and reader say its keys are. Nothing in it builds on another
/// file.
void compare_keys(const std::filesystem::path& file, const Document& any_schema, const Document& document,
                  const std::string& path, std::set<std::string>& seen) {
  const Document& schema = branch_for(document, any_schema);
  const bool named = schema.find("propertyNames") != nullptr;
  if (document.kind == Document::Kind::map && !named) {
    EXPECT_EQ(keys_of(schema, document), keys_the_reader_lists(file, path)) << path;
    seen.insert(path);
  }
  for (std::size_t i = 0; i < document.children.size(); ++i) {
    const Document& entry = document.children[i];
    if (entry.children.empty()) continue;
    const Document* inner = schema_of_entry(schema, document, entry);
    ASSERT_NE(inner, nullptr) << path << " " << entry.key;
    compare_keys(file, *inner, entry, joined_key(path, word_for(entry, i)), seen);
  }
}

TEST_F(CaseSchema, NamesExactlyTheKeysThatTheReaderKnows) {
  const CaseFolder folder;
  for (const auto& shipped : shipped_case_files()) {
    Case input = read_case(shipped);
    input.water_boundaries.at(0).name = "rain";
    input.figures.profile_reference.clear();
    input.figures.contour_times = {1.0};
    input.tractions = {{"fill", {}, {0.0, -1.0}, 0.0, 0.0}};
    const std::string resolved = resolved_yaml(input);
    std::set<std::string> seen;
    compare_keys(folder.write("case.yaml", resolved), whole_, parsed(resolved), "", seen);
    for (const char* path :
         {"", "domain", "walls", "water", "geometry.0", "initial", "initial.water", "water_boundaries.rain",
          "loads.fill", "coupling", "numerics", "clock", "failure", "stop", "output", "figures"}) {
      EXPECT_TRUE(seen.contains(path)) << path;
    }
  }
}

/// Takes every key away in turn, and gives what is left to `see`. Lists without names are all or nothing.
void without_each_key(Document& document, const Document& root,
                      const std::function<void(const Document& root, const std::string& key)>& see) {
  if (document.kind == Document::Kind::list && word_for(document.children.at(0), 0) == "0") return;
  for (std::size_t i = 0; i < document.children.size(); ++i) {
    const Document taken = document.children[i];
    const auto position = static_cast<std::ptrdiff_t>(i);
    if (taken.key != "name" && taken.key != "include") {
      document.children.erase(document.children.begin() + position);
      see(root, taken.key);
      document.children.insert(document.children.begin() + position, taken);
    }
    if (taken.kind != Document::Kind::value) without_each_key(document.children[i], root, see);
  }
}

TEST_F(CaseSchema, ACaseThatIncludesMayLeaveOutAnyKey) {
  std::set<std::string> keys;
  for (const char* name : {"quick.yaml", "paper/liakopoulos.yaml"}) {
    Document document = parsed(resolved_yaml(read_case(shipped_cases() / name)));
    document.set("include", Document::text("base.yaml"));
    without_each_key(document, document, [&](const Document& rest, const std::string& key) {
      keys.insert(key);
      EXPECT_EQ(joined_lines(schema_violations(schema_, rest)), "") << name << " without " << key;
    });
  }
  for (const char* key : {"title", "soils", "porosity", "model", "alpha", "coefficient", "water_table", "type",
                          "pressure", "at", "time", "profile_times"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

TEST_F(CaseSchema, AnIncludingCaseIsStillChecked) {
  const auto refused = [&](const std::string& text) { return !schema_violations(schema_, parsed(text)).empty(); };
  EXPECT_FALSE(refused("include: base.yaml\n"));
  EXPECT_FALSE(refused("include: base.yaml\nwater_boundaries: [{name: rain, ramp: 7 s}]\n"));
  for (const char* text :
       {"title: x\n", "include: 3\n", "include: true\n", "include: ''\n", "include: [base.yaml]\n", "include: {}\n",
        "include: base.yaml\ntitel: x\n", "include: base.yaml\nstop: {time: 3}\n", "include: base.yaml\nstop: 3 min\n",
        "include: base.yaml\nsoils: {clay: {porosity: 2}}\n",
        "include: base.yaml\nsoils: {clay: {retention: {alpha: 1 m}}}\n",
        "include: base.yaml\nsoils: {clay: {retention: {model: corey}}}\n",
        "include: base.yaml\nwater_boundaries: [{ramp: 7 s}]\n", "include: base.yaml\ngeometry: [{soil: clay}]\n"}) {
    EXPECT_TRUE(refused(text)) << text;
  }
}

TEST_F(CaseSchema, EveryAlternativeIsAccepted) {
  const std::vector<std::string> assignments{
      "soils.silty_sand.strength={model: elastic}",
      "soils.silty_sand.strength={model: von_mises, undrained_strength: 20 kPa}",
      "soils.silty_sand.strength={model: von_mises, undrained_strength: 20 kPa, softening: "
      "{residual_undrained_strength: "
      "5 kPa, from_plastic_strain: 0, to_plastic_strain: 10 %}}",
      "soils.silty_sand.strength.model=mohr_coulomb",
      "soils.silty_sand.strength={model: mohr_coulomb, cohesion: 5 kPa, friction_angle: 30 deg, dilatancy_angle: 5 "
      "deg, "
      "maximum_cohesion_increase: 0 kPa, cohesion_suction_rate: 0, friction_angle_suction_rate: 0 deg, softening: "
      "{residual_cohesion: 0 kPa, residual_friction_angle: 20 deg, from_plastic_strain: 1 %, to_plastic_strain: 10 %, "
      "characteristic_length: 0.5 m}}",
      "soils.silty_sand.strength={model: modified_cam_clay, critical_state_ratio: 0.9, lambda: 0.16, kappa: 0.04, "
      "minimum_mean_stress: 2 kPa, overconsolidation_ratio: 1.5}",
      "soils.silty_sand.strength={model: modified_cam_clay, critical_state_friction_angle: 25 deg, lambda: 0.16, "
      "kappa: "
      "0.04, minimum_mean_stress: 2 kPa, pre_overburden_pressure: 30 kPa}",
      "soils.silty_sand.strength={model: modified_cam_clay, critical_state_friction_angle: 25 deg, lambda: 0.16, "
      "kappa: "
      "0.04, minimum_mean_stress: 2 kPa, preconsolidation_pressure: 90 kPa}",
      "soils.silty_sand.retention={model: exponential, alpha: 1 1/m, residual_saturation: 0.1, maximum_saturation: 1}",
      "soils.silty_sand.retention={model: liakopoulos, coefficient: 0.1, exponent: 2, floor: 0.1}",
      "soils.silty_sand.relative_permeability={model: liakopoulos, coefficient: 2.2, exponent: 1, floor: 1e-5}",
      "soils.silty_sand.relative_permeability={model: exponential, alpha: 1 1/m}",
      "soils.silty_sand.relative_permeability={model: van_genuchten_mualem, n: 2, residual_saturation: 0, "
      "maximum_saturation: 1}",
      "walls={left: friction, right: absorbing, base: friction, left_friction: 0.2, base_friction: 0.4, "
      "absorbing_depth: "
      "20 m}",
      "water_boundaries=[{name: lake, at: free_surface, to: 12 m, initial: true, reservoir: {level: 3 m}}]",
      "water_boundaries=[{name: drain, at: base, free_drainage: true}]",
      "water_boundaries=[{name: ditch, at: left, total_head: [[0 h, 2 m], [3 h, 1 m]]}]",
      "water_boundaries=[{name: lake, at: free_surface, reservoir: {level: [[0 h, 3 m], [10 h, 2 m]]}}, {name: storm, "
      "at: free_surface, rain: {intensity: 1 mm/h}}]",
      "seismic={horizontal_coefficient: 0.1, vertical_coefficient: -5 %, start: 1 s, ramp: 2 s}",
      "initial={water: {type: uniform, pressure: 0 kPa}, stress: k0, k0_coefficient: 0.6}",
      "initial.water={type: uniform, pressure: -3 kPa}",
      "initial.water={type: hydrostatic, water_table: 1 m, maximum_suction: 50 kPa}",
  };
  const CaseFolder folder;
  for (const std::string& assignment : assignments) {
    const Case input = read_case(shipped_cases() / "quick.yaml", {assignment});
    const std::string resolved = resolved_yaml(input);
    EXPECT_EQ(joined_lines(schema_violations(schema_, parsed(resolved))), "") << assignment;
    EXPECT_EQ(resolved_yaml(read_case(folder.write("case.yaml", resolved))), resolved) << assignment;
    std::set<std::string> seen;
    compare_keys(folder.path() / "case.yaml", whole_, parsed(resolved), "", seen);
  }
}

}  // namespace
}  // namespace slope::couple::test
