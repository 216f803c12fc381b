#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace slope::couple {

// Values as bytes and back. What a type holds decides how: numbers as they are, texts and arrays after their length, a
// struct field by field as its for_each_field() lists them, each after its name, one of several types after its number.

template <class T>
concept Listed = requires(T& value) {
  T::for_each_field(value, [](const char*, auto&) {});
};

class ArchiveWriter {
 public:
  [[nodiscard]] std::string take() { return std::move(bytes_); }

  template <class T>
  requires std::is_arithmetic_v<T>
  void put(T value) { raw(&value, sizeof value); }
  template <class T>
  requires std::is_enum_v<T>
  void put(T value) { put(static_cast<std::int32_t>(value)); }
  void put(const std::string& text) {
    put_count(text.size());
    raw(text.data(), text.size());
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class... Kinds>
  void put(const std::variant<Kinds...>& value) {
    put_count(value.index());
    std::visit([this](const auto& kind) { this->put(kind); }, value);
  }
  template <class T, std::size_t size>
  void put(const std::array<T, size>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put_count(values.size());
    if constexpr (std::is_arithmetic_v<T>) {
      raw(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  template <class Value>
  void put(const std::map<std::string, Value>& values) {
    put_count(values.size());
    for (const auto& [key, value] : values) {
      put(key);
      put(value);
    }
  }
  template <Listed T>
  void put(const T& value) {
    T::for_each_field(value, [this](const char* name, const auto& field) { this->put_field(name, field); });
  }
  template <class T>
  void put_field(const char* name, const T& value) {
    put(std::string(name));
    put(value);
  }

 private:
  void put_count(std::size_t count) { put(static_cast<std::uint64_t>(count)); }
  void raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

  std::string bytes_;
};

// Every function throws std::runtime_error that says what is wrong where the bytes are not what is asked for.
class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  template <class T>
  requires std::is_arithmetic_v<T>
  void get(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      const char byte = take(1).front();
      if (byte != 0 && byte != 1) fail("neither true nor false");
      value = byte == 1;
    } else {
      std::memcpy(&value, take(sizeof value).data(), sizeof value);
    }
  }
  template <class T>
  requires std::is_enum_v<T>
  void get(T& value) {
    std::int32_t number = 0;
    get(number);
    value = static_cast<T>(number);
  }
  void get(std::string& text) { text = take(count(1)); }
  template <class T>
  void get(std::optional<T>& value) {
    bool there = false;
    get(there);
    value.reset();
    if (there) get(value.emplace());
  }
  template <class... Kinds>
  void get(std::variant<Kinds...>& value) {
    std::uint64_t found = 0, number = 0;
    get(found);
    if (found >= sizeof...(Kinds)) fail("a kind that there is not");
    const auto take_if_found = [&]<class Kind>() {
      if (number++ == found) get(value.template emplace<Kind>());
    };
    (take_if_found.template operator()<Kinds>(), ...);
  }
  template <class T, std::size_t size>
  void get(std::array<T, size>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    const std::size_t size = count(std::is_arithmetic_v<T> ? sizeof(T) : 1);
    if constexpr (std::is_arithmetic_v<T>) {
      values.resize(size);
      if (size > 0) std::memcpy(values.data(), take(size * sizeof(T)).data(), size * sizeof(T));
    } else {
      values.clear();
      for (std::size_t i = 0; i < size; ++i) get(values.emplace_back());
    }
  }
  template <class Value>
  void get(std::map<std::string, Value>& values) {
    values.clear();
    for (std::size_t left = count(1); left > 0; --left) {
      std::string key;
      get(key);
      get(values[key]);
    }
  }
  template <Listed T>
  void get(T& value) {
    T::for_each_field(value, [this](const char* name, auto& field) { this->get_field(name, field); });
  }
  template <class T>
  void get_field(const char* name, T& value) {
    std::string found;
    get(found);
    if (found != name) fail(std::string("a field that is not \"") + name + "\"");
    get(value);
  }

 private:
  // The number of entries that follow, each of some bytes at least; never more than there is room for.
  std::size_t count(std::size_t least_bytes) {
    std::uint64_t number = 0;
    get(number);
    if (number > rest_.size() / least_bytes) fail("an array that is longer than the file");
    return static_cast<std::size_t>(number);
  }
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) fail("less than there should be");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("it holds " + what + ", " + std::to_string(rest_.size()) + " bytes before its end");
  }

  std::string_view rest_;
};

}  // namespace slope::couple
