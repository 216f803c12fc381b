#include <string>

#include "case/hyetograph_file.hpp"
#include "case/input.hpp"
#include "case/profile.hpp"
#include "csv_table.hpp"
#include "fuzz_folder.hpp"
#include "xml_tags.hpp"

// The readers of tables: rain, surfaces, histories and references, and the tags of particle files. Whatever they are
// given, they throw their own errors or put what is wrong into their list.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slope;
  const auto file = fuzz::file_with("table.csv", fuzz::text_of(data, size));
  try {
    (void)couple::read_hyetograph(file);
  } catch (const couple::FileError&) {
  }
  try {
    (void)tools::read_csv(file);
  } catch (const couple::FileError&) {
  }
  std::vector<couple::Problem> problems;
  const couple::Document document = couple::Document::map();
  const std::string name = file.string();
  couple::ProfileText profile;
  profile.file = name;
  (void)couple::read_profile(couple::Input(document, name, problems), profile);
  (void)tools::xml_tags(fuzz::text_of(data, size));
  return 0;
}
