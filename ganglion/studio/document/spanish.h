#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace ganglion::studio {

/// A sentence of the checks. {} stands for what differs; in Spanish {0}, {1}... say which of them goes where.
struct Phrase {
  std::string_view en;
  std::string_view es;
};

/// Of a look at a robot and of the link to it.
std::span<const Phrase> spanish_of_links() noexcept;
/// Of files, experiments, worlds, log lines, and of what the page may ask.
std::span<const Phrase> spanish_of_files() noexcept;

/// All, the more special before the more general: the first that fits counts.
const std::vector<Phrase>& spanish_phrases();

}  // namespace ganglion::studio
