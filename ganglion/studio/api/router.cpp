#include "ganglion/studio/api/router.h"

#include <new>

#include "ganglion/base/expects.h"
#include "ganglion/base/json_depth.h"

namespace ganglion::studio {

void Router::add(std::string path, std::string_view method, Answer answer) {
  const bool fresh = routes_.try_emplace(std::move(path), Route{method, std::move(answer)}).second;
  expects(fresh);
}

Reply Router::handle(const Call& call) const {
  const auto route = routes_.find(call.path);
  if (route == routes_.end()) return failure("UnknownPath", "there is nothing at this path", 404);
  const auto& [method, answer] = route->second;
  const bool reads = method == "GET" && call.method == "HEAD";
  if (call.method != method && !reads) return failure("BadRequest", fmt::format("this path takes {}", method), 405);
  Ask ask{call, Json::object()};
  if (method == "POST") {
    if (!json_has_few_keys(call.body)) return failure("TooLarge", "an object of the body has too many keys", 413);
    ask.body = call.body.empty() ? Json::object() : parsed(call.body);
    if (!ask.body.is_object()) return ask.refuse("BadRequest", "the body must be a JSON object", 400);
  }
  if (ask.text("language") == "es") ask.language = Language::Spanish;
  try {
    return answer(ask);
  } catch (const nlohmann::json::exception&) {  // how the library says that a member is of another type
    return ask.refuse("BadRequest", "a member of the body is of another type than it should be", 400);
  } catch (const std::bad_alloc&) {
    return ask.refuse("TooLarge", "there is not enough memory for that", 413);
  }
}

}  // namespace ganglion::studio
