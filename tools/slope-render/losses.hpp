#pragma once

#include <exception>
#include <string>
#include <vector>

#include "slope/couple/read_case.hpp"

namespace slope::tools {

/// What of a run cannot be read or drawn. The rest is, and these are told at the end.
class Losses {
 public:
  /// Does something. @return false if a file or what it holds stood in the way, which is noted.
  template <class Work>
  bool attempt(Work work) {
    try {
      work();
      return true;
    } catch (const couple::InputError& error) {
      bad_input_ = true;
      note(error);
    } catch (const couple::FileError& error) {
      note(error);
    }
    return false;
  }

  /// Something that is left out of what is drawn.
  void leave_out(const std::string& what) { note(couple::FileError(what)); }

  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
  /// Whether a case is wrong, rather than a file damaged.
  [[nodiscard]] bool bad_input() const { return bad_input_; }
  /// @throws the first of what was noted, if there is any.
  void throw_first() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  template <class Error>
  void note(const Error& error) {
    if (!first_) first_ = std::make_exception_ptr(error);
    messages_.emplace_back(error.what());
  }

  std::vector<std::string> messages_;
  std::exception_ptr first_;
  bool bad_input_ = false;
};

}  // namespace slope::tools
