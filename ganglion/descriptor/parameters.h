#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// The values of one component's parameters, one for each of its descriptor's, defaults filled in, ranges held.
class Parameters {
 public:
  /// All defaults.
  explicit Parameters(std::span<const ParameterDescriptor> descriptors);

  double real(std::string_view name) const;
  int integer(std::string_view name) const;
  bool boolean(std::string_view name) const;
  /// The chosen word, and its index among the descriptor's choices.
  std::string_view choice(std::string_view name) const;
  int choice_index(std::string_view name) const;
  const std::string& word(std::string_view name) const;
  std::span<const double> reals(std::string_view name) const;

  /// Whether it was set: for kinds whose defaults hang together, a device's by its name.
  bool given(std::string_view name) const;
  void set(std::string_view name, double value);
  void set_word(std::string_view name, std::string value);
  void set_reals(std::string_view name, std::vector<double> values);

  std::span<const ParameterDescriptor> descriptors() const noexcept { return descriptors_; }

 private:
  struct Value {
    double number = 0;
    std::string word;
    std::vector<double> reals;
    bool given = false;
  };
  const Value& at(std::string_view name, ParameterType type) const;
  Value& set_at(std::string_view name);

  std::span<const ParameterDescriptor> descriptors_;
  std::vector<Value> values_;
};

}  // namespace ganglion
