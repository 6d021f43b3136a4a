#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ganglion/base/files.h"
#include "ganglion/base/result.h"

namespace ganglion::config {

class Value;
using Array = std::vector<Value>;
/// Keys in the order they stand in the file.
using Members = std::vector<std::pair<std::string, Value>>;

/// A value of a TOML file that remembers where it stands.
class Value {
 public:
  enum class Type { None, Boolean, Integer, Real, String, List, Table };

  Value() = default;
  Value(bool value, Place place) : data_(value), place_(std::move(place)) {}
  Value(std::int64_t value, Place place) : data_(value), place_(std::move(place)) {}
  Value(double value, Place place) : data_(value), place_(std::move(place)) {}
  Value(std::string value, Place place) : data_(std::move(value)), place_(std::move(place)) {}
  Value(Array value, Place place) : data_(std::move(value)), place_(std::move(place)) {}
  Value(Members value, Place place) : data_(std::move(value)), place_(std::move(place)) {}

  Type type() const noexcept { return static_cast<Type>(data_.index()); }
  /// "a number", "a text", "a list"...: for messages.
  Text type_name() const noexcept;
  const Place& place() const noexcept { return place_; }

  const bool* boolean() const noexcept { return std::get_if<bool>(&data_); }
  const std::int64_t* integer() const noexcept { return std::get_if<std::int64_t>(&data_); }
  const double* real() const noexcept { return std::get_if<double>(&data_); }
  const std::string* string() const noexcept { return std::get_if<std::string>(&data_); }
  const Array* array() const noexcept { return std::get_if<Array>(&data_); }
  const Members* table() const noexcept { return std::get_if<Members>(&data_); }
  Array* array() noexcept { return std::get_if<Array>(&data_); }
  Members* table() noexcept { return std::get_if<Members>(&data_); }
  /// The member of a table, or null.
  const Value* find(std::string_view key) const noexcept;
  Value* find(std::string_view key) noexcept;

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Members> data_;
  Place place_;
};

/// The same values under the same keys; places and the order of keys aside. 1 and 1.0 differ, NaN equals NaN.
bool equal(const Value& a, const Value& b);

/// Reads TOML 1.0. Fails with the parser's first syntax error at its place, with NotFound, or with TooLarge beyond 4
/// MiB, 64 levels or 10,000 keys in one table. Dates are refused: no file of ours has any.
Result<Value> parse(std::string_view text, const std::string& file_name);
Result<Value> load(const std::filesystem::path& path);
Result<Value> parse(const OpenedFile& file);

/// Largest file of TOML [bytes].
inline constexpr std::size_t kMaxBytes = std::size_t{4} << 20;

/// What a person gave as `--set path=value`; the value is read as TOML, or as text where it is not TOML.
struct Override {
  std::string path;  ///< "run.duration_s", "acting.escape.trigger_range_m": lists of tables by their `id`.
  std::string value;
};

/// Splits "path=value". Fails with Syntax.
Result<Override> parse_override(std::string_view text);

/// Puts a value where `path` leads, making tables that are missing. Its place is "--set path=value", so that errors say
/// so. Fails with UnknownKey where a list has no item of that id, with BadType where the path runs through a plain
/// value.
Result<void> apply(Value& root, const Override& override);

}  // namespace ganglion::config
