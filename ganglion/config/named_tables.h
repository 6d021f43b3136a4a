#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ganglion/config/table.h"

namespace ganglion::config {

/// Most tables of one list, such as [[sensor]] or [[task]].
inline constexpr std::size_t kMaxNamedTables = 1024;

/// Reports a name that is empty, of other letters, or taken. Whole channel names may have dots: "sonar.range".
void check_name(Table& table, std::string_view key, std::string name, bool dots, std::vector<std::string>& taken);

/// Reads each [[key]] table; those beyond the limit are one problem and are not looked at.
template <class Read>
void each_table(Table& root, std::string_view key, Read read) {
  std::vector<Table> tables = root.tables(key);
  if (tables.size() > kMaxNamedTables) {
    root.problem(key, ErrorCode::TooLarge,
                 {"there are {} of [[{}]]; the limit is {}", "hay {} de [[{}]]; el límite es {}"}, tables.size(), key,
                 kMaxNamedTables);
  }
  std::size_t count = 0;
  for (Table& table : tables) {
    if (count++ < kMaxNamedTables) {
      read(table);
    } else {
      for (const std::string& name : table.keys()) table.known(name);
    }
  }
}

}  // namespace ganglion::config
