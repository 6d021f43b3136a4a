#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ganglion {

/// The languages of the project.
enum class Language : std::uint8_t { English, Spanish };

/// A text of ours for people, in both languages: a constant. There is none in one language only; both may be empty.
class Text {
 public:
  template <std::size_t N, std::size_t M>
  consteval Text(const char (&english)[N], const char (&spanish)[M]) noexcept  // NOLINT(google-explicit-constructor)
      : en_(english), es_(spanish) {
    static_assert((N > 1) == (M > 1), "a text says something in both languages, or in none");
  }
  /// Names and formulas that read the same in both. The text must outlive it.
  static constexpr Text same(std::string_view text) noexcept { return Text(text); }

  constexpr std::string_view in(Language language) const noexcept { return language == Language::English ? en_ : es_; }
  constexpr bool empty() const noexcept { return en_.empty(); }

 private:
  constexpr explicit Text(std::string_view text) noexcept : en_(text), es_(text) {}
  std::string_view en_, es_;
};

/// A sentence for people with its arguments filled in, in both languages.
struct Sentence {
  std::string en, es;

  /// What others said (a robot, the system), or a name: quoted as it came.
  static Sentence quoted(std::string words) {
    std::string again = words;
    return {std::move(words), std::move(again)};
  }
  const std::string& in(Language language) const noexcept { return language == Language::English ? en : es; }
  bool empty() const noexcept { return en.empty(); }
  Sentence& operator+=(const Sentence& more) {
    en += more.en;
    es += more.es;
    return *this;
  }
  friend bool operator==(const Sentence&, const Sentence&) = default;
};

/// An argument of a sentence as one language says it: a Sentence or Text in it, anything else as it is.
inline const std::string& spoken(Language language, const Sentence& sentence) { return sentence.in(language); }
inline std::string_view spoken(Language language, const Text& text) { return text.in(language); }
template <class T>
const T& spoken(Language, const T& value) {
  return value;
}
template <class T>
using Spoken = std::remove_cvref_t<decltype(spoken(Language::English, std::declval<const T&>()))>;

/// Both wordings of one sentence; the compiler holds their places for arguments against the arguments.
template <class... Args>
class Wording {
 public:
  template <std::size_t N, std::size_t M>
  consteval Wording(const char (&english)[N], const char (&spanish)[M])  // NOLINT(google-explicit-constructor)
      : en(english), es(spanish) {
    if (places(english) != places(spanish)) throw "one language names an argument that the other does not";
  }
  fmt::format_string<Spoken<Args>...> en, es;

 private:
  static consteval int places(std::string_view text) {
    int count = 0;
    for (const char c : text) count += c == '{' ? 1 : 0;
    return count;
  }
};

namespace detail {
// Not for the caller: one body for each list of spoken types, whatever the types that were told.
template <class... Told>
std::string filled(fmt::string_view words, const Told&... told) {
  return fmt::vformat(words, fmt::make_format_args(told...));
}
}  // namespace detail

/// `say({"{} goals reached", "{} metas alcanzadas"}, count)`
template <class... Args>
Sentence say(Wording<std::type_identity_t<Args>...> words, const Args&... args) {
  return {detail::filled<Spoken<Args>...>(words.en, spoken(Language::English, args)...),
          detail::filled<Spoken<Args>...>(words.es, spoken(Language::Spanish, args)...)};
}

}  // namespace ganglion
