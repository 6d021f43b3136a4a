#include "ganglion/config/named_tables.h"

namespace ganglion::config {
namespace {

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

}  // namespace

void check_name(Table& table, std::string_view key, std::string name, bool dots, std::vector<std::string>& taken) {
  std::string undotted = name;
  if (dots) std::erase(undotted, '.');
  const bool plain =
      !undotted.empty() && name.size() <= 64 && undotted.find_first_not_of(kLetters) == std::string::npos;
  if (!plain && table.has(key)) {
    table.problem(
        key, ErrorCode::BadParameter,
        {"{} is \"{}\", must be 1 to 64 letters, digits{}", "{} es \"{}\", debe tener de 1 a 64 letras, cifras{}"}, key,
        name, dots ? Text{", _ or dots", ", _ o puntos"} : Text{", _", " o _"});
  }
  for (const std::string& other : taken) {
    if (other == name && !name.empty()) {
      table.problem(key, ErrorCode::BadParameter, {"{} \"{}\" is given twice", "{} \"{}\" se da dos veces"}, key, name);
    }
  }
  taken.push_back(std::move(name));
}

}  // namespace ganglion::config
