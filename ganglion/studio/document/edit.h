#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

/// What came of operations on a text.
struct Edited {
  std::string text;
  std::vector<std::string> ids;  ///< Of components that were made or renamed, as they are called now.
};

/// Carries out operations (docs/studio_api.md) on the text of a controller: all, or none where one cannot be. Only what
/// an operation is about is written anew: comments, line ends and the layout of all other lines stay, and so does what is
/// not understood. A text that config::format() leaves as it is comes back as such a one. Fails with UnknownKey where a component or key is
/// not there, with BadParameter or BadType where a value cannot be; the error's place.line is the number of the
/// operation, from 0.
Result<Edited> edit(std::string_view text, const Json& operations);

/// The components of these ids with their positions, as a text that the operation "paste" takes.
/// Fails with UnknownKey.
Result<std::string> copy(std::string_view text, const std::vector<std::string>& ids);

}  // namespace ganglion::studio
