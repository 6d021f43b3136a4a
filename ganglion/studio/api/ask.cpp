#include "ganglion/studio/api/ask.h"

#include <cmath>

namespace ganglion::studio {

std::string Ask::text(const char* key) const {
  const auto found = body.find(key);
  return found != body.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double Ask::number(const char* key, double preset) const {
  const auto found = body.find(key);
  const bool good = found != body.end() && found->is_number() && std::isfinite(found->get<double>());
  return good ? found->get<double>() : preset;
}

Reply Ask::refuse(std::string_view code, const Sentence& what, unsigned status, const Json& arguments) const {
  return failure(code, what, language, status, arguments);
}

}  // namespace ganglion::studio
