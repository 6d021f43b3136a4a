#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace ganglion::testing {

/// Components of the kinds in kinds.h as they stand in a controller file, to be strung together. `settings` are further
/// lines of a table.

/// "[[sensation]]" of each channel, under its own name.
std::string sensations(std::initializer_list<std::string_view> channels);

std::string gain(std::string_view id, std::string_view in, double factor = 1);
std::string wish(std::string_view id, std::string_view settings);
/// Goes to `goal` by the sensation `place`.
std::string seeker(std::string_view id, std::string_view goal, std::string_view settings = "");
/// Acts as `act` says, with `value`: both are sources of wires.
std::string puppet(std::string_view id, std::string_view act, std::string_view value, std::string_view settings = "");
/// `candidates` as in a list: "\"one\", \"two\"".
std::string first(std::string_view id, std::string_view candidates, std::string_view settings = "");

}  // namespace ganglion::testing
