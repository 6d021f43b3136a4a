#pragma once

#include <span>
#include <string_view>

namespace ganglion::studio {

/// A sentence of the checks. {} stands for what differs; in Spanish {0}, {1}... say which of them goes where.
struct Phrase {
  std::string_view en;
  std::string_view es;
};

/// The more special before the more general: the first that fits counts.
std::span<const Phrase> spanish_phrases() noexcept;

}  // namespace ganglion::studio
