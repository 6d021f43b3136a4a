#include "ganglion/record/database/database.h"

#include <sqlite3.h>

#include <chrono>
#include <system_error>
#include <thread>

#include "ganglion/record/database/failure.h"

namespace ganglion {

namespace {

constexpr std::chrono::seconds kPatience{10};  // with another process that holds the file

/// Without a link on the way: SQLite is told to follow none, so that none that is put there leads it out.
std::string database_place(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path folder =
      std::filesystem::canonical(path.has_parent_path() ? path.parent_path() : std::filesystem::path("."), error);
  return error ? path.string() : (folder / path.filename()).string();
}

}  // namespace

Error database_failure(sqlite3* connection, const std::string& file) {
  const Sentence why =
      connection != nullptr ? Sentence::quoted(sqlite3_errmsg(connection)) : say({"out of memory", "no queda memoria"});
  const auto error = [&](ErrorCode code, Text what) {
    return Error{code, say({"{}: {}", "{}: {}"}, what, why), {file}};
  };
  switch (connection != nullptr ? sqlite3_errcode(connection) & 0xff : SQLITE_NOMEM) {
    case SQLITE_NOTADB:
      return error(ErrorCode::Corrupt, {"is no SQLite file, or its beginning is damaged",
                                        "no es un archivo SQLite, o su comienzo está dañado"});
    case SQLITE_CORRUPT:
      return error(ErrorCode::Corrupt, {"is damaged", "está dañado"});
    case SQLITE_ERROR:
    case SQLITE_SCHEMA:
    case SQLITE_MISMATCH:
    case SQLITE_CONSTRAINT:
      return error(ErrorCode::Corrupt,
                   {"has other tables than it should", "tiene tablas distintas de las que debería"});
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return error(ErrorCode::Unreadable, {"is kept busy by another program", "lo tiene ocupado otro programa"});
    case SQLITE_TOOBIG:
      return error(ErrorCode::TooLarge, {"would hold too much in one piece", "contendría demasiado en una sola pieza"});
    default:
      return error(ErrorCode::Unreadable, {"cannot be read or written", "no se puede leer ni escribir"});
  }
}

void Database::Close::operator()(sqlite3* connection) const noexcept { sqlite3_close(connection); }

Result<Database> Database::open(const std::filesystem::path& path, const DatabaseLayout& layout) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (std::filesystem::is_symlink(path, error)) {
    return fail_at({path.string()}, ErrorCode::Unsupported,
                   {"is a link; name the file that it leads to", "es un enlace; nombre el archivo al que lleva"});
  }
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    return fail_at({path.string()}, ErrorCode::Unreadable, {"is not a regular file", "no es un archivo regular"});
  Database database(path.string());
  auto outcome = database.connect(database_place(path), SQLITE_OPEN_NOFOLLOW);
  if (outcome) outcome = database.check_identity(layout);
  if (outcome) outcome = database.configure(layout);
  if (outcome) outcome = database.upgrade(layout);
  if (outcome) outcome = database.check_content(layout);
  if (!outcome) return tl::unexpected(outcome.error());
  return database;
}

Result<void> Database::connect(const std::string& place, int more_flags) {
  sqlite3* connection = nullptr;
  const int code =
      sqlite3_open_v2(place.c_str(), &connection,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX | more_flags, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) return tl::unexpected(database_failure(connection, file_));
  sqlite3_busy_timeout(connection, static_cast<int>(std::chrono::milliseconds(kPatience).count()));
  sqlite3_db_config(connection, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(connection, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  return {};
}

Result<std::int64_t> Database::integer(std::string_view sql) const {
  auto statement = prepare(sql);
  if (!statement) return tl::unexpected(statement.error());
  const auto row = statement->step();
  if (!row) return tl::unexpected(row.error());
  return *row ? statement->integer(0) : 0;
}

Result<void> Database::check_identity(const DatabaseLayout& layout) const {
  // In one statement, so that another process making the file at this moment is seen before or after, not halfway.
  auto identity = prepare("SELECT application_id, (SELECT count(*) FROM sqlite_schema) FROM pragma_application_id");
  if (!identity) return tl::unexpected(identity.error());
  if (const auto row = identity->step(); !row) return tl::unexpected(row.error());
  const std::int64_t application = identity->integer(0), objects = identity->integer(1);
  if (application != layout.application_id && (application != 0 || objects != 0)) {
    return fail_at({file_}, ErrorCode::Unsupported,
                   {"is an SQLite file, but not {}", "es un archivo SQLite, pero no {}"}, layout.what);
  }
  return {};
}

Result<void> Database::configure(const DatabaseLayout& layout) const {
  // The change to WAL is the one thing for which SQLite does not wait by itself when others are opening the file.
  const auto give_up = std::chrono::steady_clock::now() + kPatience;
  auto outcome = execute("PRAGMA journal_mode = WAL");
  while (!outcome && sqlite3_errcode(connection_.get()) == SQLITE_BUSY && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    outcome = execute("PRAGMA journal_mode = WAL");
  }
  if (!outcome) return outcome;
  return execute(layout.survives_power_cut ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
}

Result<void> Database::upgrade(const DatabaseLayout& layout) const {
  const auto newest = static_cast<std::int64_t>(layout.steps.size());
  const auto version = integer("PRAGMA user_version");
  if (!version) return tl::unexpected(version.error());
  if (*version == newest) return {};
  return transaction([&]() -> Result<void> {
    const auto current = integer("PRAGMA user_version");  // again: another process may have been faster
    if (!current) return tl::unexpected(current.error());
    if (*current < 0 || *current > newest) {
      return fail_at(
          {file_}, ErrorCode::Unsupported,
          {"was written by a newer program (its version is {}, this program knows up to {}); use that program, or "
           "another file",
           "lo escribió un programa más nuevo (su versión es {}, este programa conoce hasta la {}); use ese programa, "
           "u otro archivo"},
          *current, newest);
    }
    for (std::int64_t step = *current; step < newest; ++step) {
      if (auto outcome = execute(std::string(layout.steps[static_cast<std::size_t>(step)])); !outcome) return outcome;
    }
    return execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", layout.application_id, newest));
  });
}

Result<std::string> Database::schema() const {
  auto statement =
      prepare("SELECT type, name, sql FROM sqlite_schema WHERE name NOT LIKE 'sqlite_%' ORDER BY type, name");
  if (!statement) return tl::unexpected(statement.error());
  std::string text;
  while (true) {
    const auto row = statement->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return text;
    text += statement->text(0) + " " + statement->text(1) + " " + statement->text(2) + "\n";
  }
}

Result<void> Database::check_content(const DatabaseLayout& layout) const {
  // Tables that only look like ours (a view without end, a trigger) must not be queried: compare with freshly made
  // ones.
  Database fresh(":memory:");
  auto outcome = fresh.connect(fresh.file_, 0);
  if (outcome) outcome = fresh.upgrade(layout);
  if (!outcome) return outcome;
  const auto wanted = fresh.schema();
  const auto found = schema();
  if (!wanted) return tl::unexpected(wanted.error());
  if (!found) return tl::unexpected(found.error());
  if (*wanted != *found)
    return fail_at({file_}, ErrorCode::Corrupt,
                   {"has other tables than {} should", "tiene tablas distintas de las de {}"}, layout.what);
  auto check = prepare("PRAGMA quick_check(1)");
  if (!check) return tl::unexpected(check.error());
  const auto row = check->step();
  if (!row) return tl::unexpected(row.error());
  if (check->text(0) != "ok")
    return fail_at({file_}, ErrorCode::Corrupt, {"is damaged: {}", "está dañado: {}"}, check->text(0));
  return {};
}

Result<Statement> Database::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(connection_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr) !=
      SQLITE_OK) {
    return tl::unexpected(database_failure(connection_.get(), file_));
  }
  return Statement(statement, file_);
}

Result<void> Database::execute(const std::string& sql) const {
  if (sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    return tl::unexpected(database_failure(connection_.get(), file_));
  }
  return {};
}

Result<void> Database::transaction(const std::function<Result<void>()>& work) const {
  auto outcome = execute("BEGIN IMMEDIATE");
  if (!outcome) return outcome;
  outcome = work();
  if (outcome) outcome = execute("COMMIT");
  // A failure of the rollback itself says nothing new; SQLite has rolled back by then, or will on closing.
  if (!outcome) static_cast<void>(execute("ROLLBACK"));
  return outcome;
}

std::int64_t Database::changes() const noexcept { return sqlite3_changes64(connection_.get()); }

}  // namespace ganglion
