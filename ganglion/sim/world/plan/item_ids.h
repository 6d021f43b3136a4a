#pragma once

#include <set>
#include <string>

#include "ganglion/config/table.h"

namespace ganglion::sim {

/// Ids seen so far; they name items in messages, overrides and recordings, so each is given once.
class ItemIds {
 public:
  std::string read(config::Table& table, bool required) {
    std::string id = required ? table.text("id") : table.text("id", "");
    if (table.has("id") && id.empty())
      table.problem("id", ErrorCode::BadParameter, {"the id is empty", "el id está vacío"});
    if (!id.empty() && !seen_.insert(id).second) {
      table.problem("id", ErrorCode::BadParameter,
                    {"the id \"{}\" is taken: each item needs its own",
                     "el id \"{}\" ya está en uso: cada elemento necesita el suyo"},
                    id);
    }
    table.set_context(id);
    return id;
  }

 private:
  std::set<std::string> seen_;
};

}  // namespace ganglion::sim
