#pragma once

#include <string>
#include <string_view>

#include "ganglion/studio/api/reply.h"

namespace ganglion::studio {

/// A request that was let in.
struct Call {
  std::string method;
  std::string path;    ///< Decoded.
  std::string target;  ///< As it came, with the query.
  std::string body;
  Language language = Language::English;  ///< To answer in where the body names none.
};

/// What a route is called with.
struct Ask {
  const Call& call;
  Json body;
  Language language = Language::English;

  /// The text of that name; "" where there is none.
  std::string text(const char* key) const;
  bool has(const char* key) const { return body.contains(key) && !body[key].is_null(); }
  /// The finite number of that name, or the preset.
  double number(const char* key, double preset) const;
  /// A failure, worded in the language of this call.
  Reply refuse(std::string_view code, const Sentence& what, unsigned status,
               const Json& arguments = Json::object()) const;
};

}  // namespace ganglion::studio
