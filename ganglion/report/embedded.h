#pragma once

#include <string_view>

namespace ganglion::report {

/// player/*.js, one after the other, as they stood when the program was built.
extern const std::string_view kPlayerScript;
/// style.css.
extern const std::string_view kStyle;

}  // namespace ganglion::report
