#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "ganglion/base/sentence.h"

namespace ganglion {

/// What a described kind is part of. The first five are drawn in a controller (colours in studio.md); the rest make up
/// simulated applications.
enum class ComponentClass { Sensation, Sensing, Goal, Acting, Coordinator, Sensor, Drive, Plant };

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

struct PortDescriptor {
  std::string_view name;
  PortRole role = PortRole::Feedback;
  std::string_view unit = "";  ///< SI, "" = dimensionless, "*" = whatever is wired (see size).
  ValueType type = ValueType::Real;
  /// Values of one wire; 0 = whatever is wired. An Output left open has the shape or unit of the first open Feedback.
  int size = 1;
  std::span<const std::string_view> elements{};  ///< Names of the values where there are several, else empty.
  bool required = true;                          ///< Inputs: whether a controller must wire it.
  /// Input: takes a list of wires. Output: one value for each wire of the component's `many` input.
  bool many = false;
  Text help{"", ""};
};

bool is_input(ComponentClass, PortRole) noexcept;

enum class ParameterType { Real, Integer, Boolean, Choice, Word, Reals };
std::string_view name_of(ParameterType) noexcept;

struct ParameterDescriptor {
  std::string_view name;
  ParameterType type = ParameterType::Real;
  std::string_view unit = "";
  double preset = 0;  ///< Default; of a Choice its index, of a Boolean 0 or 1.
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::span<const std::string_view> choices{};
  std::string_view preset_word = "";       ///< Default of a Word.
  std::span<const double> preset_reals{};  ///< Default of Reals; min and max hold for each.
  int count = 0;                           ///< Reals: how many, 0 = any number.
  Text help{"", ""};
  bool ours = false;  ///< Not given by the source: our reconstruction, to be labelled so wherever it is shown.
};

/// What a kind says of itself. The loader, messages, JSON Schema, palette, forms, manual and exporter derive from it.
struct Descriptor {
  ComponentClass component_class = ComponentClass::Acting;
  std::string_view name;             ///< As written after `kind =`.
  std::string_view paper_name = "";  ///< Accepted in files as well, e.g. "AmDmr".
  Text summary{"", ""};
  std::span<const PortDescriptor> ports{};
  std::span<const ParameterDescriptor> parameters{};
  std::string_view source = "";  ///< Paper and section, or "ours".

  const PortDescriptor* port(std::string_view port_name) const noexcept;
  const ParameterDescriptor* parameter(std::string_view parameter_name) const noexcept;
};

/// Outputs that every component of a class has besides its own: of acting modules `active`, `status` and `reason`.
std::span<const PortDescriptor> common_outputs(ComponentClass) noexcept;

}  // namespace ganglion
