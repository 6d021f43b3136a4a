#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ganglion::studio {

/// The decoded value of a query's parameter; none where it is not there or badly encoded.
std::optional<std::string> query_value(std::string_view target, std::string_view name);
/// "%20" decoded; none where it is badly encoded or holds a zero.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace ganglion::studio
