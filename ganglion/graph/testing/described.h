#pragma once

#include <string_view>

#include "ganglion/descriptor/descriptor.h"

/// Descriptors of kinds that only tests see: their titles and help are their names.
namespace ganglion::testing {

constexpr PortDescriptor port(std::string_view name, PortRole role, std::string_view unit = "", int size = 1) noexcept {
  return {.name = name, .title = Text::same(name), .help = Text::same(name), .role = role, .unit = unit, .size = size};
}
constexpr PortDescriptor optional(PortDescriptor port) noexcept {
  port.required = false;
  return port;
}
constexpr PortDescriptor many(PortDescriptor port) noexcept {
  port.many = true;
  return port;
}

template <class Config, auto Member>
consteval ParameterDescriptor named(std::string_view name) {
  return parameter<Config, Member>({.name = name, .title = Text::same(name), .help = Text::same(name)});
}

}  // namespace ganglion::testing
