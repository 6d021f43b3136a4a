#pragma once

#include <string_view>

#include "ganglion/base/sentence.h"

namespace ganglion::plot {

using ganglion::Language;

/// "en" or "es".
constexpr std::string_view tag_of(Language language) noexcept { return language == Language::Spanish ? "es" : "en"; }

/// An entry of a dictionary. It cannot be left out: a dictionary with a missing word does not compile.
class Word {
 public:
  consteval Word(const char* text) : text_(text) {}  // NOLINT: a dictionary reads best without the type's name
  constexpr operator std::string_view() const noexcept { return text_; }

 private:
  std::string_view text_;
};

}  // namespace ganglion::plot
