#pragma once

#include <string>

namespace ganglion::report {

/// {"en": {key: word}, "es": {...}} for a page's script; fit to stand in a <script> element.
std::string dictionary_json();

/// JSON text with < > & written as escapes, so that no <script> element ends early, whatever the strings in it say.
std::string fit_for_script(const std::string& json);

}  // namespace ganglion::report
