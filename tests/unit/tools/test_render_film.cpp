#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "animation.hpp"
#include "picture_file.hpp"
#include "scratch_folder.hpp"
#include "synthetic_run.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

TEST(Animation, HasAFrameOfEverySnapshotInOneSizeAndNoOlderOnes) {
  const ScratchFolder scratch;
  write_slope_run(scratch.path() / "run");
  Losses losses;
  const auto run = read_run_folder(scratch.path() / "run");
  const fs::path folder = scratch.path() / "frames";
  fs::create_directories(folder);
  std::ofstream(folder / "deviatoric_strain_0004.png") << "of a longer run";
  const auto frames = write_frames(run, "deviatoric_strain", folder, 400, losses);
  ASSERT_EQ(frames.count, 4);
  const int height = PictureFile(frames.frame(0)).height();
  for (int i = 0; i < frames.count; ++i) {
    EXPECT_EQ(PictureFile(frames.frame(i)).height(), height);
  }
  EXPECT_NE(bytes_of(frames.frame(2)), bytes_of(frames.frame(3)));
  EXPECT_FALSE(fs::exists(frames.frame(4)));
}

TEST(Animation, KeepsOneScale) {
  const ScratchFolder scratch;
  Losses losses;
  write_slope_run(scratch.path() / "small", 0.1);
  write_slope_run(scratch.path() / "large", 0.9);
  const auto small =
      write_frames(read_run_folder(scratch.path() / "small"), "deviatoric_strain", scratch.path() / "a", 400, losses);
  const auto large =
      write_frames(read_run_folder(scratch.path() / "large"), "deviatoric_strain", scratch.path() / "b", 400, losses);
  EXPECT_NE(bytes_of(small.frame(0)), bytes_of(large.frame(0)))
      << "the first frame has the scale that the last one needs";
}

/// A folder that is the whole PATH while it lives.
class OnlyPath {
 public:
  OnlyPath() : before_(getenv("PATH")) { setenv("PATH", folder_.path().c_str(), 1); }
  ~OnlyPath() { setenv("PATH", before_.c_str(), 1); }
  OnlyPath(const OnlyPath&) = delete;
  OnlyPath& operator=(const OnlyPath&) = delete;

  void add(const std::string& program, const std::string& script) const {
    std::ofstream(folder_.path() / program) << "#!/bin/sh\n" << script;
    fs::permissions(folder_.path() / program, fs::perms::owner_all);
  }

 private:
  ScratchFolder folder_;
  std::string before_;
};

constexpr const char* writes_its_last_argument = "for last; do :; done\necho \"$0 $#\" > \"$last\"\n";

TEST(Film, IsMadeByTheFirstEncoderThatWorks) {
  const ScratchFolder scratch;
  Losses losses;
  write_slope_run(scratch.path() / "run");
  const auto frames = write_frames(read_run_folder(scratch.path() / "run"), "suction", scratch.path(), 400, losses);
  const OnlyPath path;

  const auto built_in = encode_film(frames, scratch.path() / "film", 4);
  EXPECT_TRUE(!built_in || built_in->filename() == "film.ogv") << "VTK's own, if it has one";

  path.add("convert", writes_its_last_argument);
  path.add("ffmpeg", "exit 1\n");
  const auto converted = encode_film(frames, scratch.path() / "film", 4);
  ASSERT_TRUE(converted.has_value());
  EXPECT_EQ(converted->filename(), "film.gif");
  EXPECT_NE(bytes_of(*converted).find("convert"), std::string::npos);

  path.add("ffmpeg", writes_its_last_argument);
  EXPECT_NE(bytes_of(*encode_film(frames, scratch.path() / "film", 4)).find("ffmpeg"), std::string::npos);
}

}  // namespace
}  // namespace slope::tools::test
