#include <sqlite3.h>

#include <limits>

#include "ganglion/record/database/database.h"
#include "ganglion/record/database/failure.h"

namespace ganglion {

void Statement::Finalize::operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }

void Statement::bind(int index, std::int64_t value) noexcept { sqlite3_bind_int64(statement_.get(), index, value); }

void Statement::bind(int index, double value) noexcept { sqlite3_bind_double(statement_.get(), index, value); }

void Statement::bind(int index, std::string_view value) noexcept {
  // An empty view may have no address, which would be stored as NULL.
  const char* text = value.empty() ? "" : value.data();
  sqlite3_bind_text64(statement_.get(), index, text, value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

void Statement::bind(int index, std::span<const std::byte> value) noexcept {
  const void* bytes = value.empty() ? static_cast<const void*>("") : value.data();
  sqlite3_bind_blob64(statement_.get(), index, bytes, value.size(), SQLITE_TRANSIENT);
}

Result<bool> Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return tl::unexpected(database_failure(sqlite3_db_handle(statement_.get()), file_));
}

Result<void> Statement::run() {
  while (true) {
    const auto row = step();
    if (row && *row) continue;
    reset();
    if (!row) return tl::unexpected(row.error());
    return {};
  }
}

void Statement::reset() noexcept { sqlite3_reset(statement_.get()); }

std::int64_t Statement::integer(int column) const noexcept { return sqlite3_column_int64(statement_.get(), column); }

double Statement::number(int column) const noexcept {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return text != nullptr ? std::string(text, size) : std::string();
}

std::vector<std::byte> Statement::bytes(int column) const {
  const auto* bytes = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return bytes != nullptr ? std::vector<std::byte>(bytes, bytes + size) : std::vector<std::byte>();
}

}  // namespace ganglion
