#pragma once

#include <string_view>

namespace ganglion::report {

/// page/words.js and player/*.js, one after the other, as they stood when the program was built.
extern const std::string_view kPlayerScript;
/// page/words.js and page/switch.js: for pages without a player.
extern const std::string_view kSwitchScript;
/// style.css.
extern const std::string_view kStyle;

}  // namespace ganglion::report
