#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace ganglion {

/// What a database of ours looks like. Step n is the SQL that brings version n to version n + 1, so the newest version
/// is steps.size(); steps are never changed once released, only added.
struct DatabaseLayout {
  Text what;                        ///< "the experience of a controller", for sentences.
  std::int32_t application_id = 0;  ///< In the file's header; tells our files from other people's.
  std::span<const std::string_view> steps;
  bool survives_power_cut = true;  ///< False: the newest commits may be lost then, never the file. kill -9 loses none.
};

/// One SQL statement with ? parameters, counted from 1; columns count from 0.
class Statement {
 public:
  void bind(int index, std::int64_t value) noexcept;
  void bind(int index, double value) noexcept;  ///< NaN is stored as NULL, as SQLite does.
  void bind(int index, std::string_view value) noexcept;
  void bind(int index, std::span<const std::byte> value) noexcept;
  /// True when there is a row to read, false at the end.
  Result<bool> step();
  /// Steps to the end and makes ready for other parameters.
  Result<void> run();
  void reset() noexcept;

  std::int64_t integer(int column) const noexcept;
  double number(int column) const noexcept;  ///< NaN for NULL.
  std::string text(int column) const;
  std::vector<std::byte> bytes(int column) const;

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };
  Statement(sqlite3_stmt* statement, std::string file) noexcept : statement_(statement), file_(std::move(file)) {}
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  std::string file_;
};

/// A thin, exception-free hold on one SQLite file in WAL mode. Several processes may have it open; one waits up to 10 s
/// for another. For one thread at a time.
class Database {
 public:
  /// Opens, or makes with its folder, and brings an older layout up to date in one transaction.
  /// Fails with Unreadable (no permission, disk full, in use, no regular file), Corrupt (no SQLite file, damaged, or tables that are not
  /// ours) or Unsupported (a newer version, an SQLite file of something else, or a link: they are left as they are).
  static Result<Database> open(const std::filesystem::path& path, const DatabaseLayout& layout);

  Result<Statement> prepare(std::string_view sql) const;
  Result<void> execute(const std::string& sql) const;
  /// Runs `work` between BEGIN IMMEDIATE and COMMIT; rolls back when it fails.
  Result<void> transaction(const std::function<Result<void>()>& work) const;
  /// Rows the last statement changed.
  std::int64_t changes() const noexcept;
  const std::string& file() const noexcept { return file_; }

 private:
  struct Close {
    void operator()(sqlite3* connection) const noexcept;
  };
  explicit Database(std::string file) : file_(std::move(file)) {}
  Result<void> connect(const std::string& place, int more_flags);
  Result<std::int64_t> integer(std::string_view sql) const;
  Result<void> check_identity(const DatabaseLayout& layout) const;
  Result<void> configure(const DatabaseLayout& layout) const;
  Result<void> upgrade(const DatabaseLayout& layout) const;
  Result<void> check_content(const DatabaseLayout& layout) const;
  Result<std::string> schema() const;

  std::string file_;
  std::unique_ptr<sqlite3, Close> connection_;
};

}  // namespace ganglion
