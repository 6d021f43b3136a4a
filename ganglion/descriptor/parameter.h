#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/units/angle.h"

namespace ganglion {

enum class ParameterType { Real, Integer, Boolean, Choice, Word, Reals, File };
std::string_view name_of(ParameterType) noexcept;

/// Largest file that a parameter may name [bytes].
inline constexpr std::size_t kMaxFileText = std::size_t{1} << 20;

/// How the names of texts that are part of the program begin: "builtin:wall.fll".
inline constexpr std::string_view kBuiltin = "builtin:";

/// The text of a file that a parameter names, UTF-8: the loader reads it, the kind opens nothing. A preset is a text of
/// the program whose name begins with kBuiltin, or none at all: both empty.
struct FileText {
  std::string name;   ///< As written in the controller file, whose folder it is relative to.
  std::string text;   ///< At most kMaxFileText.
  std::string where;  ///< Where it was found, for messages; "" = under its name.
  /// Where an error of the kind's own stands in it.
  Place at(int line, int column = 0) const { return {where.empty() ? name : where, line, column}; }
};

/// A value: a number (of a Choice its index, of a Boolean 0 or 1; an angle in degrees), a word, numbers, or a file.
using ParameterValue = std::variant<double, std::string, std::vector<double>, FileText>;

/// What a parameter says of itself. Made by parameter<>(), which ties it to the member of a Config that holds it: type,
/// default and where a value goes follow from there.
struct ParameterDescriptor {
  std::string_view name;  ///< As written in files: "trigger_range_m".
  Text title;             ///< Its name for people: "trigger range".
  Text help;
  std::string_view unit = "";
  double min = -std::numeric_limits<double>::infinity();  ///< Of Reals for each.
  double max = std::numeric_limits<double>::infinity();
  std::span<const std::string_view> choices{};
  std::span<const double> allowed{};  ///< Of a number that has only some values: 45, 90, 180. Empty = all.
  int count = 0;                      ///< Reals: how many, 0 = any number.
  bool ours = false;                  ///< Not given by the source: our reconstruction, to be labelled so.
  bool live = false;                  ///< May be changed between ticks.

  ParameterType type = ParameterType::Real;
  ParameterValue (*preset)() = nullptr;  ///< The default: what the member is in a Config that nobody touched.
  void (*store)(void* config, const ParameterValue& value) = nullptr;
  const char* config = nullptr;  ///< Which Config: the address of its tag.
};

namespace detail {

template <class Config>
inline constexpr char kConfigTag = 0;

template <class T>
consteval ParameterType type_for() {
  if constexpr (std::is_same_v<T, bool>) {
    return ParameterType::Boolean;
  } else if constexpr (std::is_enum_v<T>) {
    return ParameterType::Choice;
  } else if constexpr (std::is_integral_v<T>) {
    return ParameterType::Integer;
  } else if constexpr (std::is_same_v<T, std::string>) {
    return ParameterType::Word;
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    return ParameterType::Reals;
  } else if constexpr (std::is_same_v<T, FileText>) {
    return ParameterType::File;
  } else {
    static_assert(std::is_same_v<T, double> || std::is_same_v<T, Angle>, "a parameter of a type that no file can hold");
    return ParameterType::Real;
  }
}

template <class T>
ParameterValue to_value(const T& member) {
  if constexpr (std::is_same_v<T, Angle>) {
    return std::round(member.deg() * 1e9) / 1e9;  // degrees to radians and back are a bit off
  } else if constexpr (std::is_enum_v<T> || std::is_arithmetic_v<T>) {
    return static_cast<double>(member);
  } else {
    return member;
  }
}

template <class T>
void from_value(T& member, const ParameterValue& value) {
  if constexpr (std::is_same_v<T, Angle>) {
    member = Angle::from_deg(std::get<double>(value));
  } else if constexpr (std::is_same_v<T, bool>) {
    member = std::get<double>(value) != 0;
  } else if constexpr (std::is_enum_v<T>) {
    member = static_cast<T>(static_cast<int>(std::get<double>(value)));
  } else if constexpr (std::is_arithmetic_v<T>) {
    member = static_cast<T>(std::get<double>(value));
  } else {
    member = std::get<T>(value);
  }
}

}  // namespace detail

/// `parameter<EscapeConfig, &EscapeConfig::back_s>({.name = "back_s", .title = {...}, .help = {...}, .unit = "s"})`
///
/// `Member` points to a member of Config or of a base of it, or is a lambda without captures that gives one by
/// reference. Config is named by itself because &Derived::inherited is a pointer to a member of the base.
template <class Config, auto Member>
consteval ParameterDescriptor parameter(ParameterDescriptor said) {
  using Value = std::remove_cvref_t<decltype(std::invoke(Member, std::declval<Config&>()))>;
  said.type = detail::type_for<Value>();
  said.preset = [] {
    Config untouched{};
    return detail::to_value<Value>(std::invoke(Member, untouched));
  };
  said.store = [](void* config, const ParameterValue& value) {
    detail::from_value<Value>(std::invoke(Member, *static_cast<Config*>(config)), value);
  };
  said.config = &detail::kConfigTag<Config>;
  return said;
}

}  // namespace ganglion
