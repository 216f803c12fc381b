#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/format.hpp"
#include "case/input.hpp"
#include "slope/couple/results.hpp"

/// How values stand in a summary. As with cases, one description reads, writes and makes the JSON Schema. Unlike cases,
/// numbers are in SI units that their key names, every key is written, and null is what is not known or did not happen.
/// What is damaged is a problem; what another version of the program may have named otherwise is a warning.
namespace slope::couple {

template <class V>
struct ResultFormat {
  std::function<void(const Input&, V&)> read;
  std::function<Document(const V&)> write;
  std::function<void(V&)> forget;  ///< makes it what it is where a file does not tell it
  Document schema;
  std::string unit = "";  ///< of its numbers: "m", "m3/m", "-"; empty: they have none
};

/// A finite number, or null, which is NaN.
[[nodiscard]] ResultFormat<double> measured(std::string_view unit);
/// [x, y] (m)
[[nodiscard]] ResultFormat<Point> place();
[[nodiscard]] ResultFormat<std::size_t> count();
[[nodiscard]] ResultFormat<bool> yes_or_no();
[[nodiscard]] ResultFormat<std::string> words();
/// Amounts by names that are not known beforehand.
[[nodiscard]] ResultFormat<std::map<std::string, double>> by_name(std::string_view unit);

/// What is added to a name for its unit: "_m3_per_m".
[[nodiscard]] std::string unit_suffix(std::string_view unit);
[[nodiscard]] Document with_null(Document schema);
[[nodiscard]] Document described_key(Document schema, const std::string& meaning, const std::string& unit);
void report_unknown_keys(const Input& map, const std::vector<FieldHead>& keys);
[[nodiscard]] Document words_schema(const std::vector<std::pair<std::string, std::string>>& words);

/// One of some words. Its meaning, as earlier summaries have it in place of the word, is understood too.
template <class E, std::size_t size>
ResultFormat<E> word_of(const std::array<Word<E>, size>& words) {
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::string> names;
  for (const Word<E>& word : words) {
    texts.emplace_back(word.text, word.meaning);
    names.emplace_back(word.text);
  }
  const auto read = [words, names](const Input& input, E& value) {
    const auto text = expect_value(input, "one word" + suggestion("", names));
    if (!text) return;
    for (const Word<E>& word : words) {
      if (*text != word.text && *text != word.meaning) continue;
      value = word.value;
      return;
    }
    input.warning("unknown word \"" + shortened(*text) + '"' + suggestion(*text, names));
  };
  const auto write = [words](const E& value) {
    for (const Word<E>& word : words) {
      if (word.value == value) return Document::text(std::string(word.text));
    }
    return Document{};
  };
  return {read, write, [](E& value) { value = E{}; }, words_schema(texts)};
}

/// What may not have happened: null then.
template <class V>
ResultFormat<std::optional<V>> maybe(const ResultFormat<V>& format) {
  const auto read = [format](const Input& input, std::optional<V>& value) {
    value.reset();
    if (input.node().kind != Document::Kind::empty) format.read(input, value.emplace());
  };
  const auto write = [format](const std::optional<V>& value) { return value ? format.write(*value) : Document{}; };
  return {read, write, [](std::optional<V>& value) { value.reset(); }, with_null(format.schema), format.unit};
}

template <class V>
ResultFormat<std::vector<V>> list_of(const ResultFormat<V>& item) {
  Document schema = Document::map();
  schema.set("type", Document::text("array")).set("items", item.schema);
  const auto read = [item](const Input& input, std::vector<V>& values) {
    values.clear();
    if (!expect_list(input, 0)) return;
    for (std::size_t i = 0; i < input.node().children.size(); ++i) item.read(input.item(i), values.emplace_back());
  };
  const auto write = [item](const std::vector<V>& values) {
    Document list = Document::list();
    for (const V& value : values) list.children.push_back(item.write(value));
    return list;
  };
  return {read, write, [](std::vector<V>& values) { values.clear(); }, std::move(schema)};
}

/// A map of known keys, each with a meaning. What is written is what is described: there is no other way to add a key.
template <class T>
class ResultRecord {
 public:
  /// @param name  without its unit, which the format knows
  /// @param access  pointer to member, or a function from a T to a reference to the part meant
  template <class Access, class V>
  ResultRecord& key(const std::string& name, Access access, const ResultFormat<V>& format, const std::string& meaning) {
    const std::string full = name + unit_suffix(format.unit);
    keys_.push_back(
        {{full, true, "", described_key(format.schema, meaning, format.unit)},
         [access, read = format.read](const Input& input, T& value) { read(input, std::invoke(access, value)); },
         [access, write = format.write](const T& value) { return write(std::invoke(access, value)); },
         [access, forget = format.forget](T& value) { forget(std::invoke(access, value)); },
         ""});
    return *this;
  }

  /// The last key is not written if it is empty.
  ResultRecord& left_out_if(std::function<bool(const T&)> empty) {
    keys_.back().head.required = false;
    keys_.back().left_out = std::move(empty);
    return *this;
  }

  /// The last key had another name before, under which it is still read.
  ResultRecord& once(const std::string& former) {
    keys_.back().former = former;
    return *this;
  }

  /// A text that is always the same.
  ResultRecord& constant(const std::string& name, const std::string& text, const std::string& meaning) {
    Document schema = Document::map();
    schema.set("const", Document::text(text));
    keys_.push_back({{name, true, "", described_key(std::move(schema), meaning, "")},
                     [text](const Input& input, T&) {
                       const auto found = expect_value(input, '"' + text + '"');
                       if (found && *found != text) input.warning("expected \"" + text + '"');
                     },
                     [text](const T&) { return Document::text(text); },
                     [](T&) {},
                     ""});
    return *this;
  }

  [[nodiscard]] ResultFormat<T> format() const {
    return {[*this](const Input& input, T& value) { read(input, value); },
            [*this](const T& value) { return write(value); }, [*this](T& value) { forget(value); },
            object_schema(heads())};
  }

 private:
  struct Key {
    FieldHead head;
    std::function<void(const Input&, T&)> read;
    std::function<Document(const T&)> write;
    std::function<void(T&)> forget;
    std::string former;
    std::function<bool(const T&)> left_out = {};
  };

  [[nodiscard]] std::vector<FieldHead> heads() const {
    std::vector<FieldHead> heads;
    for (const Key& key : keys_) heads.push_back(key.head);
    return heads;
  }

  void read(const Input& input, T& value) const {
    forget(value);
    if (!expect_map(input, 0)) return;
    std::vector<FieldHead> known = heads();
    for (const Key& key : keys_) {
      const bool formerly = !key.former.empty() && !input.has(key.head.name) && input.has(key.former);
      const std::string& name = formerly ? key.former : key.head.name;
      if (formerly) known.push_back({key.former, false, "", {}});
      if (input.has(name)) {
        key.read(input.at(name), value);
      } else if (key.head.required) {
        input.warning_with(name, "missing");
      }
    }
    report_unknown_keys(input, known);
  }

  [[nodiscard]] Document write(const T& value) const {
    Document map = Document::map();
    for (const Key& key : keys_) {
      if (!key.left_out || !key.left_out(value)) map.set(key.head.name, key.write(value));
    }
    return map;
  }

  void forget(T& value) const {
    for (const Key& key : keys_) key.forget(value);
  }

  std::vector<Key> keys_;
};

/// A record of what may not have happened, which one of its values tells: null then.
template <class T>
ResultFormat<T> only_if(std::function<bool(const T&)> happened, const ResultRecord<T>& record,
                        const std::string& teller) {
  const ResultFormat<T> format = record.format();
  const auto read = [=](const Input& input, T& value) {
    if (input.node().kind == Document::Kind::empty) return format.forget(value);
    format.read(input, value);
    if (input.has(teller) && input.at(teller).node().kind == Document::Kind::empty)
      input.at(teller).problem("expected a number, got nothing");
  };
  const auto write = [=](const T& value) { return happened(value) ? format.write(value) : Document{}; };
  return {read, write, format.forget, with_null(format.schema)};
}

}  // namespace slope::couple
