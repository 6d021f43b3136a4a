#pragma once

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// The languages of the project.
enum class Language { English, Spanish };

/// A text in one of them; in English where there is no Spanish.
constexpr std::string_view in(Language language, const Text& text) noexcept {
  return language == Language::Spanish && !text.es.empty() ? text.es : text.en;
}

}  // namespace ganglion
