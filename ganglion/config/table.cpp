#include "ganglion/config/table.h"

#include <cmath>

#include "ganglion/base/text.h"

namespace ganglion::config {
namespace {

const Value& empty_table() {
  static const Value kEmpty(Members{}, Place{});
  return kEmpty;
}

std::optional<double> as_number(const Value& value) noexcept {
  if (const auto* real = value.real()) return *real;
  if (const auto* integer = value.integer()) return static_cast<double>(*integer);
  return std::nullopt;
}

bool holds(const Range& range, double number) noexcept {
  return std::isfinite(number) && number <= range.max && (range.above_min ? number > range.min : number >= range.min);
}

}  // namespace

Table::Table(const Value& value, std::string context, Problems& problems, Outline* outline)
    : value_(&value), place_(value.place()), context_(std::move(context)), problems_(&problems), outline_(outline) {
  if (value_->type() == Value::Type::Table) return;
  report(value.place(), ErrorCode::BadType,
         say({"is {}, must be a table", "es {}, debe ser una tabla"}, value.type_name()));
  value_ = &empty_table();
  mute_ = true;
}

Table::Table(Table&& other) noexcept
    : value_(other.value_),
      place_(std::move(other.place_)),
      context_(std::move(other.context_)),
      problems_(other.problems_),
      outline_(other.outline_),
      files_(other.files_),
      list_(std::move(other.list_)),
      known_(std::move(other.known_)),
      finished_(other.finished_),
      mute_(other.mute_) {
  other.finished_ = true;
}

bool Table::has(std::string_view key) const {
  if (outline_ != nullptr) outline_->mention(key);
  return value_->find(key) != nullptr;
}

void Table::known(std::string_view key) {
  if (outline_ != nullptr) outline_->mention(key);
  known_.emplace(key);
}

void Table::asks(std::string_view key, Asked asked) const {
  if (outline_ != nullptr) outline_->ask(key, std::move(asked));
}

void Table::is_of(const Descriptor& kind) const {
  if (outline_ != nullptr) outline_->be(kind);
}

Place Table::place(std::string_view key) const {
  const Value* found = value_->find(key);
  return found != nullptr ? found->place() : place_;
}

const Value* Table::value(std::string_view key) {
  known(key);
  return value_->find(key);
}

void Table::report(const Place& where, ErrorCode code, Sentence what, Subject subject) const {
  if (mute_) return;
  subject.component = context_;
  if (!context_.empty()) what = say({"{}: {}", "{}: {}"}, context_, what);
  problems_->add(Error{code, std::move(what), where, std::move(subject)});
}

void Table::problem(std::string_view key, Error error) const {
  if (error.subject.part.empty()) error.subject.part = key;
  report(error.place.file.empty() ? place(key) : error.place, error.code, std::move(error.what),
         std::move(error.subject));
}

void Table::missing(std::string_view key) const {
  report(place_, ErrorCode::MissingKey, say({"{} is missing", "falta {}"}, key), {.part = std::string(key)});
}

void Table::wrong_type(std::string_view key, const Value& found, const Sentence& wanted) const {
  report(found.place(), ErrorCode::BadType,
         say({"{} is {}, must be {}", "{} es {}, debe ser {}"}, key, found.type_name(), wanted),
         {.part = std::string(key)});
}

double Table::checked(std::string_view key, const Value& found, double preset, const Range& range) const {
  const auto number = as_number(found);
  if (!number) {
    wrong_type(key, found, say({"a number", "un número"}));
    return preset;
  }
  if (holds(range, *number)) return *number;
  report(found.place(), ErrorCode::BadParameter,
         say({"{} is {}, must be {}", "{} es {}, debe ser {}"}, key, shortest(*number), text_of(range)),
         {.part = std::string(key), .found = shortest(*number)});
  return preset;
}

double Table::number(std::string_view key, double preset, const Range& range) {
  asks(key, {.form = Asked::Form::Number, .range = range, .preset = preset});
  const Value* found = value(key);
  return found != nullptr ? checked(key, *found, preset, range) : preset;
}

double Table::number(std::string_view key, const Range& range) {
  asks(key, {.form = Asked::Form::Number, .required = true, .range = range});
  if (value(key) == nullptr) missing(key);
  return number(key, std::isfinite(range.min) ? range.min + (range.above_min ? 1 : 0) : 0, range);
}

int Table::integer(std::string_view key, int preset, const Range& range) {
  const Range whole{std::max(range.min, -2147483647.0), std::min(range.max, 2147483647.0), range.above_min};
  asks(key, {.form = Asked::Form::Whole, .range = whole, .preset = static_cast<double>(preset)});
  const Value* found = value(key);
  if (found == nullptr) return preset;
  if (found->integer() == nullptr) {
    wrong_type(key, *found, say({"a whole number", "un número entero"}));
    return preset;
  }
  return static_cast<int>(checked(key, *found, preset, whole));
}

bool Table::boolean(std::string_view key, bool preset) {
  asks(key, {.form = Asked::Form::Boolean, .preset = preset});
  const Value* found = value(key);
  if (found == nullptr) return preset;
  if (found->boolean() == nullptr) wrong_type(key, *found, say({"true or false", "true o false"}));
  return found->boolean() != nullptr ? *found->boolean() : preset;
}

std::string Table::text(std::string_view key, std::string_view preset) {
  asks(key, {.form = Asked::Form::Text, .preset = std::string(preset)});
  const Value* found = value(key);
  if (found == nullptr) return std::string(preset);
  if (found->string() == nullptr) wrong_type(key, *found, say({"a text in quotes", "un texto entre comillas"}));
  return found->string() != nullptr ? *found->string() : std::string(preset);
}

std::string Table::text(std::string_view key) {
  asks(key, {.form = Asked::Form::Text, .required = true});
  if (value(key) == nullptr) missing(key);
  return text(key, "");
}

int Table::choice(std::string_view key, std::span<const std::string_view> choices, int preset) {
  const std::vector<std::string> names(choices.begin(), choices.end());
  asks(key, {.form = Asked::Form::Choice, .choices = names, .preset = names[static_cast<std::size_t>(preset)]});
  const Value* found = value(key);
  if (found == nullptr) return preset;
  if (found->string() == nullptr) {
    wrong_type(key, *found, say({"one of {}", "uno de {}"}, join(names)));
    return preset;
  }
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choices[i] == *found->string()) return static_cast<int>(i);
  }
  report(found->place(), ErrorCode::BadParameter,
         say({"{} is \"{}\"{}", "{} es \"{}\"{}"}, key, *found->string(), suggestion(*found->string(), names)),
         {.part = std::string(key), .found = *found->string(), .choices = names});
  return preset;
}

std::vector<double> Table::numbers(std::string_view key, std::vector<double> preset, std::size_t count,
                                   const Range& range) {
  asks(key, {.form = Asked::Form::Numbers, .range = range, .least = count, .most = count, .preset = preset});
  const Value* found = value(key);
  if (found == nullptr) return preset;
  const Array* items = found->array();
  if (count == 0 && as_number(*found)) return {checked(key, *found, 0, range)};
  if (items == nullptr) {
    wrong_type(key, *found,
               count != 0 ? say({"a list of {} numbers", "una lista de {} números"}, count)
                          : say({"a list of numbers", "una lista de números"}));
    return preset;
  }
  if (count != 0 && items->size() != count) {
    report(found->place(), ErrorCode::BadType,
           say({"{} has {} number{}, must have {}", "{} tiene {} número{}, debe tener {}"}, key, items->size(),
               items->size() == 1 ? "" : "s", count),
           {.part = std::string(key)});
    return preset;
  }
  std::vector<double> result;
  for (const Value& item : *items) result.push_back(checked(key, item, 0, range));
  return result;
}

std::vector<std::string> Table::texts(std::string_view key) {
  asks(key, {.form = Asked::Form::Texts});
  const Value* found = value(key);
  if (found == nullptr) return {};
  if (const std::string* one = found->string()) return {*one};
  std::vector<std::string> result;
  if (found->array() == nullptr) {
    wrong_type(key, *found, say({"a text or a list of texts", "un texto o una lista de textos"}));
    return result;
  }
  for (const Value& item : *found->array()) {
    if (item.string() != nullptr) {
      result.push_back(*item.string());
    } else {
      wrong_type(key, item, say({"a list of texts only", "una lista solo de textos"}));
    }
  }
  return result;
}

std::filesystem::path Table::path(std::string_view key) {
  const std::filesystem::path written = text(key, "");
  const Value* found = value_->find(key);
  if (written.empty() || found == nullptr || written.is_absolute()) return written;
  if (found->place().file.starts_with("--set ")) return written;
  return std::filesystem::path(found->place().file).parent_path() / written;
}

int Table::open(std::string_view key, std::string_view role, std::size_t most_bytes) {
  const std::string named = text(key, "");
  const Value* found = value_->find(key);
  if (named.empty() || found == nullptr || files_ == nullptr) return -1;
  const auto opened = files_->open(role, named, files_->index_of(found->place().file), most_bytes);
  if (opened) return *opened;
  const std::string written = path(key).string();
  const Error& error = opened.error();
  const Sentence what = error.code == ErrorCode::NotFound
                            ? say({"{}: there is no file \"{}\"", "{}: no existe el archivo \"{}\""}, key, written)
                            : say({"{}: \"{}\" {}", "{}: \"{}\" {}"}, key, written, error.what);
  report(place(key), error.code, what, {.part = std::string(key), .found = written});
  return -1;
}

Outline* Table::inside(std::string_view key, Asked::Form form) const {
  return outline_ != nullptr ? &outline_->ask(key, {.form = form}).inside.emplace_back() : nullptr;
}

Table Table::within(const Value& value, std::string context, std::string_view key, Asked::Form form) const {
  Table result(value, std::move(context), *problems_, inside(key, form));
  result.files_ = files_;
  result.list_ = key;
  return result;
}

Table Table::table(std::string_view key) {
  const Value* found = value(key);
  std::string inner = context_.empty() ? std::string(key) : fmt::format("{}.{}", context_, key);
  Table result = within(found != nullptr ? *found : empty_table(), std::move(inner), key, Asked::Form::Table);
  if (found == nullptr) result.place_ = place_;
  return result;
}

std::vector<Table> Table::tables(std::string_view key) {
  const Value* found = value(key);
  std::vector<Table> result;
  if (found == nullptr) {
    if (outline_ != nullptr) result.push_back(within(empty_table(), context_, key, Asked::Form::Tables));
    for (Table& sample : result) sample.mute_ = true;
    return result;
  }
  if (found->array() == nullptr) {
    wrong_type(key, *found, say({"written as [[{}]]", "escrito como [[{}]]"}, key));
    return result;
  }
  for (const Value& item : *found->array()) result.push_back(within(item, context_, key, Asked::Form::Tables));
  return result;
}

std::vector<std::string> Table::keys() const {
  std::vector<std::string> names;
  for (const auto& [name, member] : *value_->table()) names.push_back(name);
  return names;
}

void Table::finish() {
  if (finished_) return;
  finished_ = true;
  const std::vector<std::string> candidates(known_.begin(), known_.end());
  for (const auto& [name, member] : *value_->table()) {
    if (known_.contains(name)) continue;
    report(member.place(), ErrorCode::UnknownKey,
           say({"\"{}\" is no key here{}", "\"{}\" no es una clave aquí{}"}, name, suggestion(name, candidates)),
           {.part = name, .found = name, .choices = candidates});
  }
}

void check_format(Table& root) {
  root.asks("format", {.form = Asked::Form::Whole, .required = true, .range = {1, 1}});
  if (!root.has("format")) {
    root.problem("format", ErrorCode::MissingKey,
                 {"the file must start with format = 1", "el archivo debe empezar con format = 1"});
    return;
  }
  const int format = root.integer("format", 1);
  if (format > 1) {
    root.problem("format", ErrorCode::Unsupported,
                 {"this program reads format = 1; the file needs a newer program",
                  "este programa lee format = 1; el archivo necesita un programa más nuevo"});
  } else if (format < 1) {
    root.problem("format", ErrorCode::BadParameter, {"format is {}, must be 1", "format es {}, debe ser 1"}, format);
  }
}

}  // namespace ganglion::config
