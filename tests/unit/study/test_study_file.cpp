// Study files: what is read of them, and their schema.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "case/input.hpp"
#include "read_study.hpp"
#include "schema_checker.hpp"
#include "scratch_folder.hpp"
#include "study_results.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  return content.str();
}

couple::Document parsed(const std::string& text) {
  std::vector<couple::Problem> problems;
  couple::Document document = couple::parse_yaml(text, "text", problems, {"study", "YAML", 100'000});
  EXPECT_TRUE(problems.empty());
  return document;
}

std::string violations(const std::string& schema, const std::string& text) {
  std::string all;
  for (const std::string& line : couple::test::schema_violations(parsed(schema), parsed(text))) all += line + '\n';
  return all;
}

std::vector<fs::path> shipped_studies() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(SLOPE_CASES) / "studies")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  return files;
}

/// study.yaml of the tests, beside its case.
class StudyFile : public testing::Test {
 protected:
  StudyFile() {
    fs::copy(fs::path(SLOPE_CASES) / "quick.yaml", folder_.path() / "quick.yaml");
    fs::copy(fs::path(SLOPE_STUDY_TESTS) / "study.yaml", file_);
  }
  const ScratchFolder folder_;
  const fs::path file_ = folder_.path() / "study.yaml";
};

TEST_F(StudyFile, IsReadWithItsUnits) {
  const StudyInput input = read_study(file_);
  ASSERT_EQ(input.study.parameters.size(), 3u);
  const Parameter& cohesion = input.study.parameters[0];
  EXPECT_EQ(cohesion.unit, "kPa");
  EXPECT_EQ(std::get<Lognormal>(cohesion.distribution).mean, 1000.0);
  EXPECT_EQ(assignment(cohesion, 1234.5678), "soils.silty_sand.strength.cohesion=1.23457 kPa");
  EXPECT_EQ(input.study.parameters[1].unit, "deg");
  EXPECT_EQ(input.study.parameters[2].unit, "");
  EXPECT_EQ(input.study.questions[1].unit, "m2");
  EXPECT_EQ(input.study.failure->result, "factor");
  EXPECT_FALSE(asks_safety_alone(input.study));
  EXPECT_EQ(std::get<MonteCarlo>(input.study.design).batch, 50);
}

TEST_F(StudyFile, IsTheSameWhenItsResolvedTextIsRead) {
  const std::string resolved = resolved_yaml(read_study(file_));
  EXPECT_NE(resolved.find("batch: 50"), std::string::npos) << resolved;
  std::ofstream(file_) << resolved;
  EXPECT_EQ(resolved_yaml(read_study(file_)), resolved);
}

TEST_F(StudyFile, TellsAllThatIsWrongAtOnce) {
  std::string content = content_of(file_);
  for (const auto& [text, replacement] :
       {std::pair{"mean: 1 kPa", "mean: 1"}, std::pair{"samples: 100", "samples: -1"},
        std::pair{"slide.at_end", "slide.at_ende"}, std::pair{"failure: factor", "failure: faktor"}}) {
    content.replace(content.find(text), std::string(text).size(), replacement);
  }
  std::ofstream(file_) << content;
  try {
    static_cast<void>(read_study(file_));
    FAIL() << "nothing is told";
  } catch (const couple::InputError& error) {
    ASSERT_EQ(error.problems().size(), 4u) << error.what();
    for (const couple::Problem& problem : error.problems()) EXPECT_GT(problem.line, 0) << problem.text();
  }
}

TEST_F(StudyFile, TellsWhatIsWrongWithItsCaseToo) {
  std::string content = content_of(folder_.path() / "quick.yaml");
  content.replace(content.find("porosity: 0.35"), 14, "porosity: 35");
  std::ofstream(folder_.path() / "quick.yaml") << content;
  try {
    static_cast<void>(read_study(file_));
    FAIL() << "nothing is told";
  } catch (const couple::InputError& error) {
    ASSERT_EQ(error.problems().size(), 1u) << error.what();
    EXPECT_EQ(error.problems()[0].key, "soils.silty_sand.porosity");
  }
}

TEST_F(StudyFile, SchemaHoldsForStudiesAsWrittenAndResolved) {
  std::vector<fs::path> files = shipped_studies();
  ASSERT_FALSE(files.empty());
  files.push_back(file_);
  for (const fs::path& file : files) {
    EXPECT_EQ(violations(study_schema(), content_of(file)), "") << file;
    EXPECT_EQ(violations(study_schema(), resolved_yaml(read_study(file))), "") << file;
  }
}

TEST_F(StudyFile, SchemaRefusesWhatTheReaderRefuses) {
  for (const auto& [text, replacement] :
       {std::pair{"title: How sure", "titel: How sure"}, std::pair{"distribution: normal", "distribution: norml"},
        std::pair{"rank: -0.4", "rank: -1.4"}, std::pair{"samples: 100", "samples: 1"},
        std::pair{"maximum: 0.4, ", ""}}) {
    std::string content = content_of(file_);
    content.replace(content.find(text), std::string(text).size(), replacement);
    EXPECT_NE(violations(study_schema(), content), "") << replacement;
  }
}

}  // namespace
}  // namespace slope::tools::test
