#include "input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace slope::couple {

namespace {

std::string all_texts(const std::vector<Problem>& problems) {
  std::string out;
  for (const Problem& problem : problems) out += (out.empty() ? "" : "\n") + problem.text();
  return out;
}

}  // namespace

std::string joined_key(const std::string& parent, std::string_view name) {
  return parent.empty() ? std::string(name) : fmt::format("{}.{}", parent, name);
}

std::vector<std::string> words_of(std::string_view key) {
  std::vector<std::string> words(1);
  for (const char c : key) {
    if (c == '.') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

std::string Problem::text() const {
  std::string out = file;
  if (line > 0) out += fmt::format(":{}", line);
  if (!out.empty()) out += ": ";
  if (!key.empty()) out += key + ": ";
  return out + message;
}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(all_texts(problems)), problems_(std::move(problems)) {}

Input::Input(const Document& root, const std::string& file, std::vector<Problem>& problems,
             std::vector<Problem>* warnings)
    : node_(&root), file_(&file), problems_(&problems), warnings_(warnings) {}

Input::Input(const Input& parent, const Document& node, std::string key)
    : node_(&node),
      key_(std::move(key)),
      file_(parent.file_),
      problems_(parent.problems_),
      warnings_(parent.warnings_) {}

void Input::problem(std::string message) const {
  problems_->push_back({node_->file, node_->line, key_, std::move(message)});
}

void Input::warning(std::string message) const {
  warning_in(node_->file, node_->line, std::move(message));
}

void Input::warning_with(std::string_view name, std::string message) const {
  Input(*this, *node_, joined_key(key_, name)).warning(std::move(message));
}

void Input::warning_in(const std::string& file, int line, std::string message) const {
  if (warnings_ != nullptr) warnings_->push_back({file, line, key_, std::move(message)});
}

void Input::problem_in(const std::string& file, int line, std::string message) const {
  problems_->push_back({file, line, key_, std::move(message)});
}

void Input::problem_with(std::string_view name, std::string message) const {
  Input(*this, *node_, joined_key(key_, name)).problem(std::move(message));
}

bool Input::clean(std::string_view key) const {
  return std::none_of(problems_->begin(), problems_->end(), [&](const Problem& problem) {
    return problem.key == key || problem.key.starts_with(fmt::format("{}.", key));
  });
}

Input Input::at(std::string_view name) const {
  const Document* entry = node_->find(name);
  return entry == nullptr ? *this : Input(*this, *entry, joined_key(key_, name));
}

Input Input::item(std::size_t index) const {
  const Document& node = node_->children.at(index);
  const Document* name = node.find("name");
  const bool named = name != nullptr && name->kind == Document::Kind::value;
  return Input(*this, node, joined_key(key_, named ? name->value : std::to_string(index)));
}

}  // namespace slope::couple
