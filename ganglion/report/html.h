#pragma once

#include <string>
#include <string_view>

#include "ganglion/report/words.h"

namespace ganglion::report {

/// `text` as it may stand in HTML, in elements and quoted attributes: valid UTF-8, markup escaped.
std::string safe(std::string_view text);

/// <tag attributes data-word="key">word</tag>: an element whose word follows the language of the page.
std::string worded(std::string_view tag, Key key, plot::Language language, std::string_view attributes = "");

/// An element that says what was recorded, in the page's language, and in the other where the reader changes it.
std::string recorded(std::string_view tag, const Sentence& said, plot::Language language,
                     std::string_view attributes = "");

/// `data-label="key" aria-label="word"`: an accessible name that follows the language of the page.
std::string labelled(Key key, plot::Language language);

/// The unit that a measure's name ends in: "m" of "path_m", "m/s" of "mean_speed_mps"; "" where there is none.
std::string_view unit_of(std::string_view measure) noexcept;

/// A whole page. `body` is markup; the script may be empty. The policy in its head forbids every network access and
/// every script but this one.
std::string page(std::string_view title, plot::Language language, std::string_view body, std::string_view script);

}  // namespace ganglion::report
