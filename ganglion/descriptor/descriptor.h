#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/reason_code.h"
#include "ganglion/base/sentence.h"
#include "ganglion/descriptor/meaning.h"
#include "ganglion/descriptor/parameter.h"

namespace ganglion {

/// What a described kind is part of. The first five are drawn in a controller (colours in studio.md); the next
/// four make up applications; measures judge a run and pictures show it.
enum class ComponentClass {
  Sensation,
  Sensing,
  Goal,
  Acting,
  Coordinator,
  Sensor,
  Drive,
  Plant,
  Task,
  Measure,
  Picture
};

/// The class as written in files and JSON: "sensation", "sensing", "goal", "acting", "coordinator", "sensor"...
std::string_view name_of(ComponentClass) noexcept;

enum class ValueType {
  Real,      ///< Any double, missing readings as REP-117 has them.
  Discrete,  ///< A whole number: a cell, an event, a switch. Compared exactly.
  Circular,  ///< An angle in (-pi, pi]; differences wrap.
};
std::string_view name_of(ValueType) noexcept;

/// What flows through a port; the direction follows from the role and the class (see is_input()).
enum class PortRole {
  Request,    ///< In of acting modules: what to reach.
  Feedback,   ///< In of every class: sensations and percepts.
  Candidate,  ///< In of coordinators: commands that compete.
  Appraisal,  ///< Out of acting modules, in of sensing modules: the perception expected at the next tick.
  Command,    ///< Out of acting modules and coordinators.
  Output,     ///< Out of every class: percepts and signals.
};
std::string_view name_of(PortRole) noexcept;

/// One value of a port that has several, as in {x [m], y [m], approach [rad, circular]}.
struct ElementDescriptor {
  constexpr ElementDescriptor(const char* called,
                              std::string_view its_unit = "*",  // NOLINT(google-explicit-constructor)
                              std::optional<ValueType> its_type = {}) noexcept
      : name(called), unit(its_unit), type(its_type) {}
  std::string_view name;
  std::string_view unit;          ///< "*" = the port's.
  std::optional<ValueType> type;  ///< None = the port's.
};

struct PortDescriptor {
  std::string_view name;  ///< As written in files: "left".
  Text title;             ///< Its name for people: "left range".
  Text help;
  PortRole role = PortRole::Feedback;
  std::string_view unit = "";  ///< SI, "" = dimensionless, "*" = whatever is wired (see size).
  ValueType type = ValueType::Real;
  /// Values of one wire; 0 = whatever is wired. An Output left open has the shape or unit of the first open Feedback.
  int size = 1;
  std::span<const ElementDescriptor> elements{};  ///< Its values where there are several, else empty.
  bool required = true;                           ///< Inputs: whether a controller must wire it.
  /// Input: takes a list of wires. Output: one value for each wire of the component's `many` input.
  bool many = false;
  /// Input of a coordinator: one wire for each candidate, in their order.
  bool each_candidate = false;
  /// Request: a set-point. It is never satisfied, may be replaced at any tick, and nobody above waits for it.
  bool standing = false;
  /// Output: worked out from values that are in the digest; recorded, in no digest itself.
  bool derived = false;
  Meaning meaning = Meaning::None;  ///< Output: what it means to whoever judges a run.

  /// Values of one wire; 0 = whatever is wired.
  int width() const noexcept { return elements.empty() ? size : static_cast<int>(elements.size()); }
  std::string_view unit_of(std::size_t element) const noexcept {
    return element < elements.size() && elements[element].unit != "*" ? elements[element].unit : unit;
  }
  ValueType type_of(std::size_t element) const noexcept {
    return element < elements.size() ? elements[element].type.value_or(type) : type;
  }
};

/// A reason of its own that a kind withdraws for.
struct ReasonDescriptor {
  std::string_view name;  ///< "cornered"
  Text words;             ///< With {0} and {1} for its two numbers.
  ReasonCode like;        ///< The common one that it is a case of: all that modules above rely on.
};

bool is_input(ComponentClass, PortRole) noexcept;

/// Names of its values; empty where it has one, or any number.
std::vector<std::string> element_names(const PortDescriptor& port);

/// What a kind says of itself. The loader, messages, JSON Schema, palette, forms, manual and exporter derive from it.
struct Descriptor {
  ComponentClass component_class = ComponentClass::Acting;
  std::string_view name;             ///< As written after `kind =`.
  std::string_view paper_name = "";  ///< Accepted in files as well, e.g. "AmDmr".
  Text summary{"", ""};
  std::span<const PortDescriptor> ports{};
  std::span<const ParameterDescriptor> parameters{};
  std::span<const ReasonDescriptor> reasons{};  ///< Of Withdrawals, besides the common ones.
  /// Names of the parameters without whose values what it has learned means nothing: "cell_m" of a map of cells.
  std::span<const std::string_view> rests_on{};
  std::string_view source = "";  ///< Paper and section, or "ours".

  const PortDescriptor* port(std::string_view port_name) const noexcept;
  const ParameterDescriptor* parameter(std::string_view parameter_name) const noexcept;
};

/// Outputs that every component of a class has besides its own: of acting modules `active`, `status` and `reason`, and
/// `settled` where requests to them are standing; of coordinators `active` and, for each candidate, `share`, `wanted` and
/// `suppressed`; of goals `intensity`, `holds` and `rests_s`.
std::span<const PortDescriptor> common_outputs(ComponentClass, std::span<const PortDescriptor> ports) noexcept;
inline std::span<const PortDescriptor> common_outputs(const Descriptor& kind) noexcept {
  return common_outputs(kind.component_class, kind.ports);
}

}  // namespace ganglion
