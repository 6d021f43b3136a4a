#include "ganglion/studio/api/router.h"
#include "ganglion/base/denied.h"

#include <new>

#include "ganglion/base/expects.h"
#include "ganglion/base/json_depth.h"

namespace ganglion::studio {

void Router::add(std::string path, std::string_view method, Answer answer) {
  const bool fresh = routes_.try_emplace(std::move(path), Route{method, std::move(answer)}).second;
  expects(fresh);
}

Reply Router::handle(const Call& call) const {
  Ask ask{call, Json::object(), call.language};
  const auto route = routes_.find(call.path);
  if (route == routes_.end()) return ask.refuse("UnknownPath", nothing_there(), 404);
  const auto& [method, answer] = route->second;
  const bool reads = method == "GET" && call.method == "HEAD";
  if (call.method != method && !reads) return ask.refuse("BadRequest", takes_only(method), 405);
  if (method == "POST") {
    if (!json_has_few_keys(call.body)) {
      return ask.refuse(
          "TooLarge", say({"an object of the body has too many keys", "un objeto del cuerpo tiene demasiadas claves"}),
          413);
    }
    ask.body = call.body.empty() ? Json::object() : parsed(call.body);
    if (!ask.body.is_object()) {
      return ask.refuse("BadRequest", say({"the body must be a JSON object", "el cuerpo debe ser un objeto JSON"}),
                        400);
    }
  }
  const std::string language = ask.text("language");
  if (!language.empty()) ask.language = language == "es" ? Language::Spanish : Language::English;
  try {
    return answer(ask);
  } catch (const nlohmann::json::exception&) {  // how the library says that a member is of another type
    return ask.refuse("BadRequest",
                      say({"a member of the body is of another type than it should be",
                           "un miembro del cuerpo es de otro tipo del que debería"}),
                      400);
  } catch (const std::bad_alloc&) {
    return ask.refuse("TooLarge", say({"there is not enough memory for that", "no hay memoria suficiente para eso"}),
                      413);
  } catch (const std::exception&) {  // a thread for a run or a look at a robot, say
    return ask.refuse("TooLarge", denied().what, 503);
  }
}

}  // namespace ganglion::studio
