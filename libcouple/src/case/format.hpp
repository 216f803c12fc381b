#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "input.hpp"
#include "range.hpp"
#include "slope/couple/text_file.hpp"
#include "suggestion.hpp"

/// How values stand in a case file. One description of a value both reads it, writes it and gives its JSON Schema, so
/// that the three cannot drift apart. Descriptions are put together: quantities into records, records into lists, and
/// so on.
namespace slope::couple {

template <class V>
struct Format {
  std::function<void(const Input&, V&)> read;  ///< puts problems into the input's list; the value is then of no use
  std::function<Document(const V&)> write;     ///< an empty document: nothing to write
  Document schema;
};

/// A dimensional value with its unit, or a number without. A value that is not finite is not written.
[[nodiscard]] Format<double> quantity(Dimension dimension, const Range& range = any_value());
[[nodiscard]] Format<bool> flag();
[[nodiscard]] Format<std::string> text();
/// A path from the folder of the file that it stands in; as a value, from the folder of the case file.
[[nodiscard]] Format<std::string> path_text();
/// [x, y]
[[nodiscard]] Format<std::array<double, 2>> pair_of(Dimension dimension);

/// A name of a soil, a point, a boundary: one word, so that it can stand in a dotted key.
[[nodiscard]] Format<std::string> name_text();
[[nodiscard]] bool is_name(std::string_view text);
[[nodiscard]] std::string name_pattern();

/// What does not depend on the type of a field.
struct FieldHead {
  std::string name;
  bool required = true;
  std::string example;  ///< what a required field could look like
  Document schema;
};

[[nodiscard]] Document described(Document schema, const std::string& description);
[[nodiscard]] Document object_schema(const std::vector<FieldHead>& fields);
[[nodiscard]] Document choice_schema(const std::vector<Document>& values);
/// The schema of what is laid over a base (see merged()): nothing is required, save the names by which items are found.
[[nodiscard]] Document overlay_schema(const Document& schema);
/// Reports the keys that no field has, and the required fields that are not there; of a misspelt one only the former.
void report_keys(const Input& map, const std::vector<FieldHead>& fields);
[[nodiscard]] bool expect_list(const Input& input, std::size_t least_items);
[[nodiscard]] bool expect_map(const Input& input, std::size_t least_entries);
/// What stands there, for messages: "nothing", "a list", or the value between quotes.
[[nodiscard]] std::string kind_of(const Document& node);
/// Whether a value is more than empty and no number, true or false.
[[nodiscard]] bool is_text(const Document& value);
/// The text of a value; none, and a problem, if it is a list or a map.
[[nodiscard]] std::optional<std::string> expect_value(const Input& input, const std::string& expected);

/// One entry of a record.
template <class T>
struct Field {
  FieldHead head;
  std::function<void(const Input&, T&)> read;
  std::function<Document(const T&)> write;
};

template <class T>
std::vector<FieldHead> heads_of(const std::vector<Field<T>>& fields) {
  std::vector<FieldHead> heads;
  for (const Field<T>& field : fields) heads.push_back(field.head);
  return heads;
}

template <class T>
void read_fields(const Input& input, const std::vector<Field<T>>& fields, T& value) {
  for (const Field<T>& field : fields) {
    if (input.has(field.head.name)) field.read(input.at(field.head.name), value);
  }
}

template <class T>
void write_fields(const std::vector<Field<T>>& fields, const T& value, Document& map) {
  for (const Field<T>& field : fields) {
    Document entry = field.write(value);
    if (entry.kind != Document::Kind::empty) map.set(field.head.name, std::move(entry));
  }
}

/// A map with known keys. `access` is a pointer to member, or a function from a T to a reference to the part meant.
template <class T>
class Record {
 public:
  using Check = std::function<void(const Input&, T&)>;

  template <class Access, class V>
  Record& required(const std::string& name, Access access, Format<V> format, const std::string& description,
                   const std::string& example) {
    return field(make_field(name, access, std::move(format), description, true, example));
  }

  /// A field that keeps the value of a T{} where it is not given.
  template <class Access, class V>
  Record& optional(const std::string& name, Access access, Format<V> format, const std::string& description) {
    Field<T> made = make_field(name, access, std::move(format), description, false, "");
    const Document standard = made.write(T{});
    if (standard.kind == Document::Kind::value) made.head.schema.set("default", standard);
    return field(std::move(made));
  }

  Record& field(Field<T> added) {
    fields_.push_back(std::move(added));
    return *this;
  }

  /// Called when all fields are right on their own; may also complete the value.
  Record& check(Check check) {
    check_ = std::move(check);
    return *this;
  }

  [[nodiscard]] const std::vector<Field<T>>& fields() const { return fields_; }
  [[nodiscard]] const Check& checked_by() const { return check_; }

  [[nodiscard]] Format<T> format() const {
    // shared, since records are put into records and functions copied with all that they hold
    const auto self = std::make_shared<const Record>(*this);
    const auto read = [self](const Input& input, T& value) {
      if (!expect_map(input, 0)) return;
      const std::size_t before = input.problem_count();
      read_fields(input, self->fields_, value);
      report_keys(input, heads_of(self->fields_));
      if (self->check_ && input.problem_count() == before) self->check_(input, value);
    };
    const auto write = [self](const T& value) {
      Document map = Document::map();
      write_fields(self->fields_, value, map);
      return map.children.empty() ? Document{} : map;
    };
    return {read, write, object_schema(heads_of(fields_))};
  }

 private:
  template <class Access, class V>
  static Field<T> make_field(const std::string& name, Access access, Format<V> format, const std::string& description,
                             bool required, const std::string& example) {
    Document schema = described(format.schema, description);
    return {{name, required, example, std::move(schema)},
            [access, read = format.read](const Input& input, T& value) { read(input, std::invoke(access, value)); },
            [access, write = format.write](const T& value) { return write(std::invoke(access, value)); }};
  }

  std::vector<Field<T>> fields_;
  Check check_;
};

/// A map that begins with a word ("model: van_genuchten") which says what other keys it has: one record per alternative
/// of a std::variant.
template <class T>
class Alternatives {
 public:
  explicit Alternatives(std::string discriminator) : discriminator_(std::move(discriminator)) {}

  /// @param variant_of  function from a T to a reference to its variant, of which A is an alternative.
  template <class A, class Access>
  Alternatives& add(const std::string& name, const std::string& description, Access variant_of,
                    const Record<A>& record) {
    Alternative added{name,
                      description,
                      [variant_of](T& value) { variant_of(value) = A{}; },
                      [variant_of](const T& value) { return std::holds_alternative<A>(variant_of(value)); },
                      {},
                      {}};
    for (const Field<A>& field : record.fields()) {
      added.fields.push_back(
          {field.head,
           [variant_of, read = field.read](const Input& input, T& value) {
             read(input, std::get<A>(variant_of(value)));
           },
           [variant_of, write = field.write](const T& value) { return write(std::get<A>(variant_of(value))); }});
    }
    if (const auto check = record.checked_by()) {
      added.check = [variant_of, check](const Input& input, T& value) { check(input, std::get<A>(variant_of(value))); };
    }
    alternatives_.push_back(std::move(added));
    return *this;
  }

  /// Fields that every alternative has.
  Alternatives& shared(const Record<T>& record) {
    for (Alternative& alternative : alternatives_) {
      for (const Field<T>& field : record.fields()) alternative.fields.push_back(field);
    }
    return *this;
  }

  [[nodiscard]] Format<T> format() const {
    const auto self = std::make_shared<const Alternatives>(*this);
    return {[self](const Input& input, T& value) { self->read(input, value); },
            [self](const T& value) { return self->write(value); }, schema()};
  }

 private:
  struct Alternative {
    std::string name;
    std::string description;
    std::function<void(T&)> select;
    std::function<bool(const T&)> selected;
    std::vector<Field<T>> fields;
    std::function<void(const Input&, T&)> check;
  };

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Alternative& alternative : alternatives_) names.push_back(alternative.name);
    return names;
  }

  [[nodiscard]] std::vector<FieldHead> heads(const Alternative& alternative) const {
    Document only = Document::map();
    only.set("const", Document::text(alternative.name));
    std::vector<FieldHead> heads{{discriminator_, true, alternative.name, std::move(only)}};
    for (const FieldHead& head : heads_of(alternative.fields)) heads.push_back(head);
    return heads;
  }

  void read(const Input& input, T& value) const {
    if (!expect_map(input, 0)) return;
    if (!input.has(discriminator_)) {
      input.problem_with(discriminator_, "missing" + suggestion("", names()));
      return;
    }
    const Input chosen = input.at(discriminator_);
    const auto name = expect_value(chosen, "one word");
    if (!name) return;
    for (const Alternative& alternative : alternatives_) {
      if (alternative.name != *name) continue;
      const std::size_t before = input.problem_count();
      alternative.select(value);
      read_fields(input, alternative.fields, value);
      report_keys(input, heads(alternative));
      if (alternative.check && input.problem_count() == before) alternative.check(input, value);
      return;
    }
    chosen.problem("unknown " + discriminator_ + " \"" + shortened(*name) + '"' + suggestion(*name, names()));
  }

  [[nodiscard]] Document write(const T& value) const {
    Document map = Document::map();
    for (const Alternative& alternative : alternatives_) {
      if (!alternative.selected(value)) continue;
      map.set(discriminator_, Document::text(alternative.name));
      write_fields(alternative.fields, value, map);
    }
    return map;
  }

  [[nodiscard]] Document schema() const {
    std::vector<Document> branches;
    for (const Alternative& alternative : alternatives_) {
      branches.push_back(described(object_schema(heads(alternative)), alternative.description));
    }
    Document schema = Document::map();
    schema.set("oneOf", Document::list(std::move(branches)));
    return schema;
  }

  std::string discriminator_;
  std::vector<Alternative> alternatives_;
};

/// One of some words (of some whole numbers, if E is int).
template <class E>
Format<E> choice(std::vector<std::pair<std::string, E>> options) {
  std::vector<Document> values;
  std::vector<std::string> names;
  for (const auto& [name, value] : options) {
    if constexpr (std::is_same_v<E, int>) {
      values.push_back(Document::number(static_cast<double>(value)));
    } else {
      values.push_back(Document::text(name));
    }
    names.push_back(name);
  }
  const auto read = [options, names](const Input& input, E& value) {
    const auto word = expect_value(input, "one word" + suggestion("", names));
    if (!word) return;
    for (const auto& [name, option] : options) {
      if (name == *word) {
        value = option;
        return;
      }
    }
    input.problem("unknown choice \"" + shortened(*word) + '"' + suggestion(*word, names));
  };
  const auto write = [options, values](const E& value) {
    for (std::size_t i = 0; i < options.size(); ++i) {
      if (options[i].second == value) return values[i];
    }
    return Document{};
  };
  return {read, write, choice_schema(values)};
}

/// A list of values, all in the same format.
template <class V>
Format<std::vector<V>> list_of(Format<V> item, std::size_t least_items = 0) {
  Document schema = Document::map();
  schema.set("type", Document::text("array")).set("items", item.schema);
  if (least_items > 0) schema.set("minItems", Document::number(static_cast<double>(least_items)));
  const auto read = [read_item = item.read, least_items](const Input& input, std::vector<V>& values) {
    if (!expect_list(input, least_items)) return;
    values.assign(input.node().children.size(), V{});
    for (std::size_t i = 0; i < values.size(); ++i) read_item(input.item(i), values[i]);
  };
  const auto write = [write_item = item.write](const std::vector<V>& values) {
    Document list = Document::list();
    for (const V& value : values) list.children.push_back(write_item(value));
    return values.empty() ? Document{} : list;
  };
  return {read, write, std::move(schema)};
}

/// A map from names to values, kept as a list in which each value knows its name: V has a member `name`.
template <class V>
Format<std::vector<V>> named(Format<V> item, std::size_t least_entries = 0) {
  Document names = Document::map();
  names.set("pattern", Document::text(name_pattern()));
  Document schema = Document::map();
  schema.set("type", Document::text("object"))
      .set("propertyNames", std::move(names))
      .set("additionalProperties", item.schema);
  if (least_entries > 0) schema.set("minProperties", Document::number(static_cast<double>(least_entries)));
  const auto read = [read_item = item.read, least_entries](const Input& input, std::vector<V>& values) {
    if (!expect_map(input, least_entries)) return;
    values.clear();
    for (const Document& entry : input.node().children) {
      const Input place = input.at(entry.key);
      if (!is_name(entry.key)) place.problem("a name begins with a letter and has only letters, digits, _ and -");
      values.emplace_back();
      values.back().name = entry.key;
      read_item(place, values.back());
    }
  };
  const auto write = [write_item = item.write](const std::vector<V>& values) {
    Document map = Document::map();
    for (const V& value : values) map.set(value.name, write_item(value));
    return values.empty() ? Document{} : map;
  };
  return {read, write, std::move(schema)};
}

/// A value that may be absent.
template <class V>
Format<std::optional<V>> maybe(Format<V> format) {
  return {[read = format.read](const Input& input, std::optional<V>& value) { read(input, value.emplace()); },
          [write = format.write](const std::optional<V>& value) { return value ? write(*value) : Document{}; },
          format.schema};
}

/// A T of which only one part is in the file.
template <class T, class V, class Access>
Format<T> part(Access access, Format<V> format) {
  return {[access, read = format.read](const Input& input, T& value) { read(input, std::invoke(access, value)); },
          [access, write = format.write](const T& value) { return write(std::invoke(access, value)); }, format.schema};
}

/// A V that stands in the file as a Text: `from_text` turns one into the other and may report problems.
template <class Text, class V>
Format<V> converted(Format<Text> format, std::function<void(const Input&, const Text&, V&)> from_text,
                    std::function<Text(const V&)> to_text) {
  const auto read = [read_text = format.read, from_text](const Input& input, V& value) {
    Text as_written;
    const std::size_t before = input.problem_count();
    read_text(input, as_written);
    if (input.problem_count() == before) from_text(input, as_written, value);
  };
  return {read, [write_text = format.write, to_text](const V& value) { return write_text(to_text(value)); },
          format.schema};
}

}  // namespace slope::couple
