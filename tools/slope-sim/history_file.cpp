#include "history_file.hpp"

#include <fmt/format.h>

#include <cerrno>

#include "slope/couple/read_case.hpp"
#include "text_file.hpp"

namespace slope::tools {

HistoryFile::HistoryFile(const std::filesystem::path& file, const std::vector<couple::HistoryColumn>& columns)
    : file_(file), stream_(file) {
  for (const couple::HistoryColumn& column : columns) {
    stream_ << (&column == &columns.front() ? "" : ",") << fmt::format("{} [{}]", column.name, column.unit);
  }
  end_line();
}

HistoryFile::HistoryFile(const std::filesystem::path& file, std::uintmax_t kept_bytes) : file_(file) {
  cut_back(file, kept_bytes);
  errno = 0;
  stream_.open(file, std::ios::app);
  if (!stream_) throw couple::FileError(fmt::format("{}: cannot be written: {}", file_.string(), system_message()));
}

std::uintmax_t HistoryFile::synchronise() {
  synchronise_file(file_);
  return std::filesystem::file_size(file_);
}

void HistoryFile::add(const std::vector<double>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) stream_ << (i == 0 ? "" : ",") << fmt::format("{:.9g}", row[i]);
  end_line();
}

void HistoryFile::end_line() {
  errno = 0;
  stream_ << '\n' << std::flush;
  if (!stream_) throw couple::FileError(fmt::format("{}: cannot be written: {}", file_.string(), system_message()));
}

}  // namespace slope::tools
