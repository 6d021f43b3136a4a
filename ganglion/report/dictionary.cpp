#include "ganglion/report/dictionary.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "ganglion/report/words.h"

namespace ganglion::report {

std::string dictionary_json() {
  nlohmann::json english = nlohmann::json::object();
  nlohmann::json spanish = nlohmann::json::object();
  for (const Entry& entry : kEntries) {
    english[std::string(entry.key)] = std::string_view(entry.english);
    spanish[std::string(entry.key)] = std::string_view(entry.spanish);
  }
  const nlohmann::json both{{"en", std::move(english)}, {"es", std::move(spanish)}};
  return fit_for_script(both.dump(-1, ' ', true));
}

std::string fit_for_script(const std::string& json) {
  std::string result;
  result.reserve(json.size());
  for (const char c : json) {
    if (c == '<' || c == '>' || c == '&')
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result;
}

}  // namespace ganglion::report
