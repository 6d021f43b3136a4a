#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/expects.h"
#include "ganglion/descriptor/parameter.h"

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
  const FileText& file(std::string_view name) const;
  const ParameterValue& value(std::string_view name) const;
  /// The value as text: "0.5", "true", the chosen word, "[1, 2]"; of a file's content a hash.
  std::string text(std::string_view name) const;

  /// Whether it was set: for kinds whose defaults hang together, a device's by its name.
  bool given(std::string_view name) const;
  void set(std::string_view name, double value);
  void set_word(std::string_view name, std::string value);
  void set_reals(std::string_view name, std::vector<double> values);
  void set_file(std::string_view name, FileText file);

  std::span<const ParameterDescriptor> descriptors() const noexcept { return descriptors_; }

  /// A Config with what was given; all else is as the Config has it by itself.
  template <class Config>
  Config filled() const {
    Config config{};
    for (std::size_t i = 0; i < descriptors_.size(); ++i) {
      expects(descriptors_[i].config == &detail::kConfigTag<Config>);
      if (values_[i].given) descriptors_[i].store(&config, values_[i].value);
    }
    return config;
  }

 private:
  struct Value {
    ParameterValue value;
    bool given = false;
  };
  std::size_t index_of(std::string_view name) const;
  const ParameterValue& at(std::string_view name, ParameterType type) const;
  void set_value(std::string_view name, ParameterValue value);

  std::span<const ParameterDescriptor> descriptors_;
  std::vector<Value> values_;
};

}  // namespace ganglion
