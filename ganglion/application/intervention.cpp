#include "ganglion/application/intervention.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

std::optional<double> find_number(std::span<const NamedNumber> list, std::string_view called) noexcept {
  const auto found = std::ranges::find(list, called, &NamedNumber::name);
  return found != list.end() ? std::optional(found->value) : std::nullopt;
}

std::string filled(std::string line, const Intervention& what) {
  const auto put = [&line](const std::string& place, const std::string& value) {
    for (auto at = line.find(place); at != std::string::npos; at = line.find(place, at + value.size())) {
      line.replace(at, place.size(), value);
    }
  };
  put("{robot}", std::to_string(what.robot));
  for (const NamedNumber& one : what.arguments) put("{" + one.name + "}", fmt::format("{:.2f}", one.value));
  put("{subject}", what.subject);  // last: it is somebody's words
  return line;
}

}  // namespace

std::optional<double> Intervention::argument(std::string_view called) const noexcept {
  return find_number(arguments, called);
}

double Intervened::argument(std::string_view called) const noexcept {
  return find_number(arguments, called).value_or(std::numeric_limits<double>::quiet_NaN());
}

const InterventionDescriptor* find(std::span<const InterventionDescriptor> list, std::string_view name) noexcept {
  const auto found = std::ranges::find(list, name, &InterventionDescriptor::name);
  return found != list.end() ? &*found : nullptr;
}

Result<std::vector<double>> arguments_of(const InterventionDescriptor& descriptor, const Intervention& what) {
  std::vector<double> values;
  for (const InterventionArgument& argument : descriptor.arguments) {
    const auto value = what.argument(argument.name);
    if (!value || !std::isfinite(*value)) {
      return fail(ErrorCode::BadParameter, {"{} needs {}, a finite number", "{} necesita {}, un número finito"},
                  descriptor.title, argument.name);
    }
    values.push_back(*value);
  }
  if (what.arguments.size() != values.size()) {
    return fail(ErrorCode::BadParameter, {"{} takes {} numbers, not {}", "{} admite {} números, no {}"},
                descriptor.title, values.size(), what.arguments.size());
  }
  return values;
}

Sentence text_of(const InterventionDescriptor& descriptor, const Intervention& what) {
  return {filled(std::string(descriptor.line.in(Language::English)), what),
          filled(std::string(descriptor.line.in(Language::Spanish)), what)};
}

}  // namespace ganglion
