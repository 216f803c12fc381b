#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "slope/couple/checkpoint.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::couple {
namespace {

const Case& a_case() {
  static const Case input =
      read_case(std::string(SLOPE_CASES) + "/quick.yaml",
                {"domain.cell_size=1 m", "walls={left: roller, right: roller, base: friction, base_friction: 0.4}"});
  return input;
}

const Checkpoint& a_checkpoint() {
  static const Checkpoint checkpoint = [] {
    Simulation simulation(a_case());
    simulation.initialise();
    for (int k = 0; k < 3; ++k) simulation.advance();
    return Checkpoint{a_case().path, resolved_yaml(a_case()), {{"rows", 7.0}}, simulation.state()};
  }();
  return checkpoint;
}

std::string refusal_of(const std::string& bytes) {
  try {
    static_cast<void>(checkpoint_of(bytes, "file"));
  } catch (const FileError& error) {
    return error.what();
  }
  return "taken";
}

TEST(Checkpoint, GivesBackWhatItWasGiven) {
  const Checkpoint again = checkpoint_of(checkpoint_bytes(a_checkpoint()), "file");
  EXPECT_EQ(again.case_path, a_checkpoint().case_path);
  EXPECT_EQ(again.case_text, a_checkpoint().case_text);
  EXPECT_EQ(again.notes, a_checkpoint().notes);
  EXPECT_TRUE(again.state == a_checkpoint().state);
}

TEST(Checkpoint, GivesBackThePaceOfTheWaterAlone) {
  Simulation simulation(read_case(a_case().path, {"coupling.scheme=seepage"}));
  simulation.initialise();
  simulation.advance();
  const SimulationState state = simulation.state();
  EXPECT_TRUE(checkpoint_of(checkpoint_bytes({"", "", {}, state}), "file").state == state);
}

TEST(Checkpoint, IsRefusedWhenItIsCutOff) {
  const std::string bytes = checkpoint_bytes(a_checkpoint());
  for (std::size_t length = 0; length < bytes.size(); length += length < 200 ? 1 : 997) {
    EXPECT_NE(refusal_of(bytes.substr(0, length)).find("file: is cut off: it ends after"), std::string::npos) << length;
  }
  EXPECT_NE(refusal_of(bytes.substr(0, bytes.size() - 1)).find("is cut off"), std::string::npos);
  EXPECT_EQ(refusal_of(bytes + "x"), "file: is damaged: its checksum does not fit");
}

TEST(Checkpoint, IsRefusedWhenAByteIsAnother) {
  std::string bytes = checkpoint_bytes(a_checkpoint());
  for (std::size_t place = 0; place < bytes.size(); place += place < 200 ? 1 : 997) {
    for (const char flip : {'\x01', '\x80'}) {
      bytes[place] ^= flip;
      EXPECT_NE(refusal_of(bytes), "taken") << place;
      bytes[place] ^= flip;
    }
  }
  bytes[20] ^= 1;
  EXPECT_EQ(refusal_of(bytes), "file: is damaged: its checksum does not fit");
}

TEST(Checkpoint, IsRefusedWhenItIsSomethingElse) {
  EXPECT_EQ(refusal_of("title: a case"), "file: is not a checkpoint of slope-sim");
  EXPECT_EQ(refusal_of(std::string(1000, '\0')), "file: is not a checkpoint of slope-sim");
}

TEST(Checkpoint, OfAnotherCaseIsRefusedWithTheLineThatDiffers) {
  EXPECT_NO_THROW(require_case_of(a_checkpoint(), a_case()));
  Case other = a_case();
  other.soils.at(0).porosity = 0.4;
  try {
    require_case_of(a_checkpoint(), other);
    FAIL() << "taken";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("porosity: 0.35\" there and \""), std::string::npos) << text;
    EXPECT_NE(text.find("porosity: 0.4\" here"), std::string::npos) << text;
  }
}

TEST(Checkpoint, ThatCannotBeWrittenLeavesTheOlderOne) {
  std::string folder = (std::filesystem::temp_directory_path() / "slope-checkpoint-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::filesystem::path file = std::filesystem::path(folder) / "checkpoint.bin";
  write_checkpoint(file, a_checkpoint());
  std::filesystem::create_directory(file.string() + ".tmp");
  EXPECT_THROW(write_checkpoint(file, a_checkpoint()), FileError);
  EXPECT_TRUE(read_checkpoint(file).state == a_checkpoint().state);
  EXPECT_THROW(static_cast<void>(read_checkpoint(folder)), FileError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace slope::couple
