#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/sentence.h"

namespace ganglion {

/// Number of letters to change, insert, delete or swap with a neighbour to turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to a mistyped word, case aside; none if it would take more than a third of its letters.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "sonar_left"?`, or `; valid: a, b, c` where nothing is near (at most 12 named), or nothing at all: the
/// end of a sentence.
Sentence suggestion(std::string_view word, std::span<const std::string> candidates);

/// "a, b, c".
std::string join(std::span<const std::string> words, std::string_view separator = ", ");

/// The shortest decimal text that reads back as the same double; "nan", "inf", "-inf".
std::string shortest(double value);

/// Reads a whole word as a double in the C locale, with "nan", "inf", "-inf"; none if anything is left over.
std::optional<double> parse_number(std::string_view word) noexcept;

/// Parts between separators, untrimmed; "" gives one empty part.
std::vector<std::string> split(std::string_view text, char separator);

/// The same for a terminal: control characters as "\\x1b", and at most `most` bytes of it, then "...".
std::string printable(std::string_view text, std::size_t most = 2000);

/// Bytes of the letter that a text begins with; 0 = it does not begin with UTF-8. Source: RFC 3629.
std::size_t letter_bytes(std::string_view text) noexcept;

/// Where a text stops being UTF-8; none if all of it is.
std::optional<std::size_t> first_not_utf8(std::string_view text) noexcept;

/// Without white space at either end.
std::string_view trimmed(std::string_view text) noexcept;

}  // namespace ganglion
