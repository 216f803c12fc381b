#include "slope/couple/checkpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "archive.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view mark = "slope checkpoint";
constexpr std::uint64_t version = 4;
constexpr std::size_t head_size = 48;
constexpr std::size_t checksum_size = sizeof(XXH128_canonical_t);
static_assert(mark.size() + 2 * sizeof(std::uint64_t) + checksum_size == head_size);

/// Of what stands before the checksum, save the mark, and of the body after it.
std::string checksum_of(std::string_view numbers, std::string_view body) {
  XXH3_state_t* state = XXH3_createState();
  if (state == nullptr) throw std::bad_alloc();
  XXH3_128bits_reset(state);
  XXH3_128bits_update(state, numbers.data(), numbers.size());
  XXH3_128bits_update(state, body.data(), body.size());
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state));
  XXH3_freeState(state);
  return {reinterpret_cast<const char*>(canonical.digest), checksum_size};
}

template <class Self, class Visit>
void for_each_field_of(Self& checkpoint, const Visit& visit) {
  visit("case_path", checkpoint.case_path);
  visit("case_text", checkpoint.case_text);
  visit("notes", checkpoint.notes);
  visit("state", checkpoint.state);
}

/// A file descriptor that is closed at the end.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : number_(open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] bool write_all(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(number_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }
  [[nodiscard]] bool sync() const { return fsync(number_) == 0; }
  bool close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
  }

 private:
  int number_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
  ArchiveWriter body_writer;
  for_each_field_of(checkpoint, [&](const char* name, const auto& field) { body_writer.put_field(name, field); });
  const std::string body = body_writer.take();
  ArchiveWriter numbers_writer;
  numbers_writer.put(version);
  numbers_writer.put(static_cast<std::uint64_t>(body.size()));
  const std::string numbers = numbers_writer.take();
  return std::string(mark) + numbers + checksum_of(numbers, body) + body;
}

Checkpoint checkpoint_of(std::string_view bytes, const std::string& name) {
  const auto refuse = [&name](const std::string& why) { throw FileError(name + ": " + why); };
  if (bytes.substr(0, mark.size()) != mark.substr(0, bytes.size())) refuse("is not a checkpoint of slope-sim");
  if (bytes.size() < head_size) refuse(fmt::format("is cut off: it ends after {} bytes", bytes.size()));
  const std::string_view numbers = bytes.substr(mark.size(), 2 * sizeof(std::uint64_t));
  const std::string_view checksum = bytes.substr(mark.size() + numbers.size(), checksum_size);
  const std::string_view body = bytes.substr(head_size);
  std::uint64_t found_version = 0, length = 0;
  ArchiveReader numbers_reader(numbers);
  numbers_reader.get(found_version);
  numbers_reader.get(length);
  if (body.size() < length) {
    refuse(fmt::format("is cut off: it ends after {} of {} bytes", bytes.size(), head_size + length));
  }
  if (body.size() > length || checksum_of(numbers, body) != checksum) refuse("is damaged: its checksum does not fit");
  if (found_version != version) {
    refuse(fmt::format("is of version {}, and this program reads version {}; go on with the slope-sim that wrote it",
                       found_version, version));
  }
  Checkpoint checkpoint;
  try {
    ArchiveReader reader(body);
    for_each_field_of(checkpoint, [&](const char* field_name, auto& field) { reader.get_field(field_name, field); });
    if (!reader.at_end()) throw std::runtime_error("it holds more than it should");
  } catch (const std::runtime_error& error) {
    // its checksum fits, so it is what was written, by a program that has other fields
    refuse(fmt::format("is of another version of slope-sim ({}); go on with the one that wrote it", error.what()));
  }
  return checkpoint;
}

void write_checkpoint(const fs::path& file, const Checkpoint& checkpoint) {
  const std::string bytes = checkpoint_bytes(checkpoint);
  const fs::path unfinished = file.string() + ".tmp";
  const auto refuse = [&] {
    const int reason = errno;
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    throw FileError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(reason)));
  };
  Descriptor descriptor(unfinished, O_WRONLY | O_CREAT | O_TRUNC);
  if (!descriptor.is_open() || !descriptor.write_all(bytes) || !descriptor.sync() || !descriptor.close()) refuse();
  if (std::rename(unfinished.c_str(), file.c_str()) != 0) refuse();
  // the new name has to come to the disk too; where a folder cannot be synchronised, the system does it in its time
  const Descriptor folder(file.has_parent_path() ? file.parent_path() : fs::path("."), O_RDONLY | O_DIRECTORY);
  if (folder.is_open()) static_cast<void>(folder.sync());
}

Checkpoint read_checkpoint(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw FileError(fmt::format("{}: {}", file.string(), error ? error.message() : "is not a file"));
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream || stream.bad()) {
    throw FileError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  }
  return checkpoint_of(content.view(), file.string());
}

void require_case_of(const Checkpoint& checkpoint, const Case& input) {
  const std::string text = resolved_yaml(input);
  if (text == checkpoint.case_text) return;
  const auto there = lines_of(checkpoint.case_text), here = lines_of(text);
  std::size_t line = 0;
  while (line < there.size() && line < here.size() && there[line] == here[line]) ++line;
  const auto shown = [line](const std::vector<std::string>& lines) {
    return line < lines.size() ? fmt::format("\"{}\"", lines[line].substr(0, 100)) : std::string("nothing");
  };
  throw InputError(
      {{input.path, 0, "",
        fmt::format("is not the case of the checkpoint: line {} of the resolved case is {} there and {} here", line + 1,
                    shown(there), shown(here))}});
}

}  // namespace slope::couple
