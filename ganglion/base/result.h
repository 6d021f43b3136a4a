#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "ganglion/base/sentence.h"

namespace ganglion {

/// Where in a file something was written; line and column count from 1, 0 = unknown.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// What went wrong, as a word that a program can rely on; the sentence for people is in Error::what.
enum class ErrorCode {
  Syntax,        ///< The file is not of its format.
  UnknownKey,    ///< A key, kind, port or name that nothing answers to.
  MissingKey,    ///< Something required is absent.
  BadType,       ///< A value of another type than asked for.
  BadParameter,  ///< A value outside its range, or values that contradict each other.
  BadWire,       ///< A wire that cannot be: dangling, of another shape or unit, part of a cycle, a second writer.
  TooLarge,      ///< Over a stated limit.
  NotFound,      ///< A file or folder that is not there.
  Unreadable,    ///< Input failed.
  Unwritable,    ///< Output failed: disk full, no permission, no such folder.
  Corrupt,       ///< A file that was damaged or cut.
  Unsupported,   ///< Well-formed, but of a version or feature we do not handle.
  LinkLost,      ///< A robot that cannot be reached, went silent, or refused.
};

/// The code's name, as written in JSON output: "BadWire".
std::string_view name_of(ErrorCode code) noexcept;

/// What an error is about, for whoever offers to mend it: nobody needs to parse the sentence.
struct Subject {
  std::string component;             ///< Its id; "" = the file.
  std::string part;                  ///< Port ("in.left"), parameter or key.
  std::string found;                 ///< The value as written.
  std::vector<std::string> choices;  ///< What would have been right, nearest first.
};

/// An error that a person can act on: place, the value found, and what would have been right.
struct Error {
  ErrorCode code = ErrorCode::BadParameter;
  Sentence what{};
  Place place{};
  Subject subject{};
  /// "file:line:column: what", leaving out what is unknown; printable() whatever a file held.
  std::string text(Language language = Language::English) const;
};

/// A value, or the reason why there is none. Whoever calls must look at it.
template <class T>
class [[nodiscard]] Result : public tl::expected<T, Error> {
 public:
  using tl::expected<T, Error>::expected;
};

/// `return fail(ErrorCode::BadParameter, {"cell_m is {}, must be > 0", "cell_m es {}, debe ser > 0"}, cell_m);`
template <class... Args>
tl::unexpected<Error> fail(ErrorCode code, Wording<std::type_identity_t<Args>...> words, const Args&... args) {
  return tl::unexpected<Error>(Error{code, say<Args...>(words, args...)});
}

/// The same with a place.
template <class... Args>
tl::unexpected<Error> fail_at(Place place, ErrorCode code, Wording<std::type_identity_t<Args>...> words,
                              const Args&... args) {
  return tl::unexpected<Error>(Error{code, say<Args...>(words, args...), std::move(place)});
}

/// Gathers every problem of a load, so that a person mends a file in one go.
class Problems {
 public:
  void add(Error error) {
    if (full()) {
      ++untold_;
    } else {
      errors_.push_back(std::move(error));
    }
  }
  template <class... Args>
  void add(Place place, ErrorCode code, Wording<std::type_identity_t<Args>...> words, const Args&... args) {
    add(Error{code, say<Args...>(words, args...), std::move(place)});
  }
  /// Nothing is wrong, but there is a better way to say it; as many are kept as of problems.
  void note(Place place, Sentence what) {
    if (notes_.size() < kMost) notes_.push_back({std::move(place), std::move(what)});
  }
  struct Note {
    Place place;
    Sentence what;
    /// "robot.toml:3:1: note: ..."
    Sentence text() const;
  };
  const std::vector<Note>& notes() const noexcept { return notes_; }
  bool empty() const noexcept { return errors_.empty(); }
  std::size_t size() const noexcept { return errors_.size(); }
  /// Later ones are only counted: nobody mends more in one go, and a hostile file has no end of them.
  bool full() const noexcept { return errors_.size() >= kMost; }
  /// In the order of the files' lines, each problem once.
  std::vector<Error> sorted() const;
  /// One problem a line, and at last how many more there are.
  std::string text(Language language = Language::English) const;

 private:
  static constexpr std::size_t kMost = 500;
  std::vector<Error> errors_;
  std::vector<Note> notes_;
  std::size_t untold_ = 0;
};

}  // namespace ganglion
