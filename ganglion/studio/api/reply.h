#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "ganglion/base/result.h"
#include "ganglion/base/sentence.h"
#include "ganglion/studio/live/messages.h"

namespace ganglion::studio {

/// What is sent back.
struct Reply {
  unsigned status = 200;
  std::string type = "application/json";
  std::string body;
  bool sandboxed = false;  ///< A page that came from a file: it may run its own scripts, and reach nothing here.
};

inline Reply json_reply(const Json& json) { return {200, "application/json", dumped(json)}; }

/// A failure in words and code; the status follows from the code where none is given.
Reply failure(std::string_view code, const Sentence& what, Language language, unsigned status,
              const Json& arguments = Json::object());
Reply failure(const Error& error, Language language, const Json& arguments = Json::object());

/// Two that the server says too, of what lies outside of the API.
Sentence nothing_there();
Sentence takes_only(std::string_view method);

}  // namespace ganglion::studio
