#pragma once

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {

/// Most [[sensor]], [[sensation]] or [[command]] tables of one file.
inline constexpr std::size_t kMaxRobotParts = 1024;

/// Reports a name that is empty, of other letters, or taken. Whole channel names may have dots: "sonar.range".
void check_name(config::Table& table, std::string_view key, std::string name, bool dots,
                std::vector<std::string>& taken);

/// Reads each [[key]] table; those beyond the limit are one problem and are not looked at.
template <class Read>
void each_table(config::Table& root, std::string_view key, Read read) {
  std::vector<config::Table> tables = root.tables(key);
  if (tables.size() > kMaxRobotParts) {
    root.problem(key, ErrorCode::TooLarge,
                 {"there are {} of [[{}]]; the limit is {}", "hay {} de [[{}]]; el límite es {}"}, tables.size(), key,
                 kMaxRobotParts);
  }
  std::size_t count = 0;
  for (config::Table& table : tables) {
    if (count++ < kMaxRobotParts) {
      read(table);
    } else {
      for (const std::string& name : table.keys()) table.known(name);
    }
  }
}

/// The form of a file that only describes: [[sensation]] and [[command]].
void read_described(config::Table& root, RobotDescription& description);

}  // namespace ganglion::sim
