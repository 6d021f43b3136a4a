#include "ganglion/record/signal_table.h"

namespace ganglion {

std::optional<std::size_t> SignalTable::column(std::string_view name) const noexcept {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == name) return i;
  }
  return std::nullopt;
}

}  // namespace ganglion
