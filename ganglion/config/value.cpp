#include "ganglion/config/value.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <toml++/toml.h>

#include "ganglion/base/file.h"
#include "ganglion/config/lexer.h"
#include "ganglion/config/syntax_hint.h"

namespace ganglion::config {
namespace {

constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxKeys = 10'000;  // keys are looked for one by one

Place place_of(const toml::node& node, const std::string& file) {
  return {file, static_cast<int>(node.source().begin.line), static_cast<int>(node.source().begin.column)};
}

Result<Value> convert(const toml::node& node, const std::string& file, int depth);

Result<Value> convert_array(const toml::array& array, const std::string& file, int depth) {
  Array items;
  for (const toml::node& item : array) {
    auto value = convert(item, file, depth + 1);
    if (!value) return value;
    items.push_back(std::move(*value));
  }
  return Value(std::move(items), place_of(array, file));
}

Result<Value> convert_table(const toml::table& table, const std::string& file, int depth) {
  if (table.size() > kMaxKeys) {
    return fail_at(place_of(table, file), ErrorCode::TooLarge,
                   {"has {} keys; the limit of a table is {}", "tiene {} claves; el límite de una tabla es {}"},
                   table.size(), kMaxKeys);
  }
  Members members;
  for (const auto& [key, node] : table) {
    auto value = convert(node, file, depth + 1);
    if (!value) return value;
    members.emplace_back(std::string(key.str()), std::move(*value));
  }
  auto position = [](const auto& member) {
    return std::pair(member.second.place().line, member.second.place().column);
  };
  std::stable_sort(members.begin(), members.end(),
                   [&](const auto& a, const auto& b) { return position(a) < position(b); });
  return Value(std::move(members), place_of(table, file));
}

Result<Value> convert(const toml::node& node, const std::string& file, int depth) {
  const Place place = place_of(node, file);
  if (depth > kMaxDepth)
    return fail_at(place, ErrorCode::TooLarge,
                   {"tables and lists nested deeper than {}", "tablas y listas anidadas a más de {} niveles"},
                   kMaxDepth);
  if (const auto* value = node.as_boolean()) return Value(value->get(), place);
  if (const auto* value = node.as_integer()) return Value(std::int64_t{value->get()}, place);
  if (const auto* value = node.as_floating_point()) return Value(value->get(), place);
  if (const auto* value = node.as_string()) return Value(value->get(), place);
  if (const auto* value = node.as_array()) return convert_array(*value, file, depth);
  if (const auto* value = node.as_table()) return convert_table(*value, file, depth);
  return fail_at(place, ErrorCode::BadType,
                 {"dates and times are not used here; write a number or a text in quotes",
                  "aquí no se usan fechas ni horas; escriba un número o un texto entre comillas"});
}

}  // namespace

Text Value::type_name() const noexcept {
  static constexpr std::array<Text, 7> kNames = {{{"nothing", "nada"},
                                                  {"true or false", "true o false"},
                                                  {"a whole number", "un número entero"},
                                                  {"a number", "un número"},
                                                  {"a text", "un texto"},
                                                  {"a list", "una lista"},
                                                  {"a table", "una tabla"}}};
  return kNames[data_.index()];
}

const Value* Value::find(std::string_view key) const noexcept {
  if (const Members* members = table()) {
    for (const auto& [name, value] : *members) {
      if (name == key) return &value;
    }
  }
  return nullptr;
}

Value* Value::find(std::string_view key) noexcept {
  return const_cast<Value*>(static_cast<const Value*>(this)->find(key));
}

Result<Value> parse(std::string_view text, const std::string& file_name) {
  if (text.size() > kMaxBytes) {
    return fail_at({file_name}, ErrorCode::TooLarge,
                   {"has {} bytes; the limit is {}", "tiene {} bytes; el límite es {}"}, text.size(), kMaxBytes);
  }
  if (auto shallow = check_nesting(text, file_name, 2 * kMaxDepth); !shallow) {
    return tl::unexpected<Error>(shallow.error());
  }
  try {
    return convert(toml::parse(text, file_name), file_name, 0);
  } catch (const toml::parse_error& error) {  // the library as Debian builds it reports by exception
    const Place place{file_name, static_cast<int>(error.source().begin.line),
                      static_cast<int>(error.source().begin.column)};
    return fail_at(place, ErrorCode::Syntax, {"not valid TOML: {}", "no es TOML válido: {}"},
                   syntax_hint(error.description()));
  }
}

Result<Value> parse(const OpenedFile& file) { return parse(*file.text, file.resolved.string()); }

Result<Value> load(const std::filesystem::path& path) {
  const auto text = read_file(path, kMaxBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return parse(*text, path.string());
}

}  // namespace ganglion::config
