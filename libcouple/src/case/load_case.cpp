#include "load_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "case_format.hpp"
#include "slope/couple/text_file.hpp"
#include "suggestion.hpp"

namespace slope::couple {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 4'000'000;  // of a case file: what is longer belongs into a table

/// A file error says who asked for the file.
std::string content_for(const Document& place, const fs::path& file) {
  try {
    return read_text_file(file, most_bytes);
  } catch (const FileError& error) {
    throw FileError(Problem{place.file, place.line, place.key, error.what()}.text());
  }
}

void refuse_missing(const Input& place, const fs::path& file, const std::vector<Problem>& problems) {
  std::error_code error;
  if (fs::exists(file, error) || error) return;
  place.problem(fmt::format("there is no file {}; the path counts from the folder of this file", file.string()));
  throw InputError(problems);
}

/// A case file being read, and its bases.
class Loader {
 public:
  explicit Loader(std::vector<Problem>& problems) : problems_(problems) {}

  Document load(const fs::path& file, const std::string& content) {
    const std::string name = file.string();
    files_.push_back(name);
    Document document = parse_yaml(content, name, problems_);
    if (document.kind == Document::Kind::empty && !problems_.empty()) throw InputError(problems_);
    const Document* include = document.find(include_key);
    if (include == nullptr) return document;
    const Document base = load_base(Input(document, name, problems_).at(include_key), file.parent_path());
    std::erase_if(document.children, [](const Document& entry) { return entry.key == include_key; });
    return merged(base, document);
  }

  [[nodiscard]] std::vector<std::string> files() && { return std::move(files_); }

 private:
  Document load_base(const Input& include, const fs::path& folder) {
    std::string name;
    const std::size_t before = problems_.size();
    include_format().read(include, name);
    if (problems_.size() > before) throw InputError(problems_);
    const fs::path file = folder / name;
    refuse_missing(include, file, problems_);
    refuse_circle(include, file);
    const Document base = load(file, content_for(include.node(), file));
    if (!expect_map(Input(base, file.string(), problems_), 0)) throw InputError(problems_);
    return base;
  }

  void refuse_circle(const Input& include, const fs::path& file) const {
    const auto same = [&](const std::string& other) {
      std::error_code error;
      return fs::equivalent(other, file, error);
    };
    const auto first = std::find_if(files_.begin(), files_.end(), same);
    if (first == files_.end()) return;
    const std::vector<std::string> circle(first, files_.end());
    include.problem(fmt::format("goes in a circle: {} -> {}; remove one of these includes", fmt::join(circle, " -> "),
                                circle.front()));
    throw InputError(problems_);
  }

  std::vector<Problem>& problems_;
  std::vector<std::string> files_;
};

std::string name_of(const Document& item) {
  const Document* name = item.find("name");
  return name != nullptr && name->kind == Document::Kind::value ? name->value : "";
}

bool is_list_of_named(const Document& document) {
  return document.kind == Document::Kind::list && !document.children.empty() &&
         std::none_of(document.children.begin(), document.children.end(),
                      [](const Document& item) { return name_of(item).empty(); });
}

/// Whether the keys of one map mean nothing to the other.
bool differ_in_kind(const Document& base, const Document& over) {
  const auto other_word = [&](const char* word) {
    const Document* before = base.find(word);
    const Document* now = over.find(word);
    return before != nullptr && now != nullptr && before->kind == Document::Kind::value && before->value != now->value;
  };
  const auto other_condition = [&](const auto& conditions) {
    const auto condition_of = [&](const Document& map) {
      return std::find_if(conditions.begin(), conditions.end(),
                          [&](const char* key) { return map.find(key) != nullptr; });
    };
    const auto before = condition_of(base);
    const auto now = condition_of(over);
    return before != now && before != conditions.end() && now != conditions.end();
  };
  return other_condition(water_conditions) || other_condition(rain_conditions) || other_word("model") ||
         other_word("type");
}

Document merged_maps(const Document& base, const Document& over) {
  Document result = over;
  result.children = base.children;
  for (const Document& entry : over.children) {
    const Document* before = base.find(entry.key);
    result.set(entry.key, before == nullptr ? entry : merged(*before, entry));
  }
  return result;
}

/// An item whose name is given twice is not merged twice: the reader is to see, and report, the second one.
Document merged_lists(const Document& base, const Document& over) {
  Document result = over;
  result.children = base.children;
  std::vector<bool> taken(base.children.size());
  for (const Document& item : over.children) {
    const auto same_name = [&](const Document& other) { return name_of(other) == name_of(item); };
    const auto found = std::find_if(base.children.begin(), base.children.end(), same_name);
    const auto i = static_cast<std::size_t>(found - base.children.begin());
    if (found == base.children.end() || taken[i]) {
      result.children.push_back(item);
    } else {
      result.children[i] = merged(*found, item);
      taken[i] = true;
    }
  }
  return result;
}

/// The file that a soil names, read once.
const Document& library_at(const Input& from, std::map<fs::path, Document>& libraries, std::vector<std::string>& files,
                           std::vector<Problem>& problems) {
  std::string path;
  const std::size_t before = problems.size();
  library_format().read(from, path);
  if (problems.size() > before) throw InputError(problems);
  const std::string& named_in = from.node().file == override_source ? from.file() : from.node().file;
  const fs::path file = fs::path(named_in).parent_path() / path;
  const auto known = libraries.find(file);
  if (known != libraries.end()) return known->second;
  refuse_missing(from, file, problems);
  Document library = parse_yaml(content_for(from.node(), file), file.string(), problems);
  if (library.kind == Document::Kind::empty) throw InputError(problems);
  files.push_back(file.string());
  return libraries.emplace(file, std::move(library)).first->second;
}

/// A soil of a library with everything that the case says in its place.
Document library_soil(const Input& place, std::map<fs::path, Document>& libraries, std::vector<std::string>& files,
                      std::vector<Problem>& problems) {
  const Input from = place.at(library_key);
  const Document& library = library_at(from, libraries, files, problems);
  const Document* soils = library.find("soils");
  if (soils == nullptr || soils->kind != Document::Kind::map || soils->children.empty()) {
    from.problem(fmt::format("{} has no soils; it needs the key \"soils\" with a map of them", library.file));
    throw InputError(problems);
  }
  Document over = place.node();
  std::string name = over.key;
  if (place.has(library_soil_key)) {
    const std::size_t before = problems.size();
    text().read(place.at(library_soil_key), name);
    if (problems.size() > before) throw InputError(problems);
  }
  const Document* soil = soils->find(name);
  if (soil == nullptr) {
    std::vector<std::string> names;
    for (const Document& entry : soils->children) names.push_back(entry.key);
    place.at(place.has(library_soil_key) ? library_soil_key : library_key)
        .problem(fmt::format("{} has no soil \"{}\"{}", soils->file, shortened(name), suggestion(name, names)));
    throw InputError(problems);
  }
  std::erase_if(over.children,
                [](const Document& entry) { return entry.key == library_key || entry.key == library_soil_key; });
  return merged(*soil, over);
}

}  // namespace

Document merged(const Document& base, const Document& over) {
  const bool maps = base.kind == Document::Kind::map && over.kind == Document::Kind::map;
  if (maps && !differ_in_kind(base, over)) return merged_maps(base, over);
  if (is_list_of_named(base) && is_list_of_named(over)) return merged_lists(base, over);
  return over;
}

LoadedCase load_case(const fs::path& file, std::vector<Problem>& problems) {
  Loader loader(problems);
  Document document = loader.load(file, read_text_file(file, most_bytes));
  return {std::move(document), std::move(loader).files()};
}

void take_library_soils(Document& document, const fs::path& file, std::vector<std::string>& files,
                        std::vector<Problem>& problems) {
  const std::string name = file.string();
  Document* soils = document.find("soils");
  if (soils == nullptr || soils->kind != Document::Kind::map) return;
  std::map<fs::path, Document> libraries;
  for (std::size_t i = 0; i < soils->children.size(); ++i) {
    Document& soil = soils->children[i];
    if (soil.find(library_key) == nullptr) continue;
    const Input place = Input(document, name, problems).at("soils").at(soil.key);
    soil = library_soil(place, libraries, files, problems);
  }
}

}  // namespace slope::couple
