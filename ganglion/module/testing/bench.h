#pragma once

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/module/acting_module.h"
#include "ganglion/module/sensing_module.h"

namespace ganglion::testing {

/// One `key = value` of a component's table.
struct Setting {
  constexpr Setting(std::string_view key, double value) : name(key), number(value) {}
  constexpr Setting(std::string_view key, const char* value) : name(key), word(value) {}
  std::string_view name;
  double number = 0;
  std::string_view word{};  ///< Of a Choice or Word; empty = `number` counts.
};

/// The parameters of a kind with some of them set, as the loader would hand them over.
inline Parameters settings(const Descriptor& descriptor, std::initializer_list<Setting> list) {
  Parameters parameters(descriptor.parameters);
  for (const Setting& setting : list) {
    const ParameterDescriptor* known = descriptor.parameter(setting.name);
    expects(known != nullptr);
    if (setting.word.empty()) {
      parameters.set(setting.name, setting.number);
    } else if (known->type == ParameterType::Choice) {
      std::size_t index = 0;
      while (index < known->choices.size() && known->choices[index] != setting.word) ++index;
      expects(index < known->choices.size());
      parameters.set(setting.name, static_cast<double>(index));
    } else {
      parameters.set_word(setting.name, std::string(setting.word));
    }
  }
  return parameters;
}

/// Drives one component by hand, without a graph: values on its ports by name. Required inputs are wired from the
/// start, optional ones and the wires of a `many` port by wire(), before the first tick. Unset values are NaN.
template <class Product>
class Bench {
 public:
  explicit Bench(const Kind<Product>& kind, std::initializer_list<Setting> list = {}) : descriptor_(kind.descriptor) {
    auto made = kind.make(settings(descriptor_, list));
    expects(made.has_value());
    product_ = std::move(*made);
    for (const PortDescriptor& port : descriptor_.ports) {
      if (is_input(descriptor_.component_class, port.role)) {
        inputs_.push_back({&port, {}, {}});
        if (port.required) wire(port.name);
      } else if (port.role == PortRole::Output) {
        outputs_.push_back({&port, std::vector<double>(port.size > 0 ? port.size : 1, kUnset), {}});
      }
    }
  }

  void wire(std::string_view port, std::size_t wires = 1) {
    Port& input = find(inputs_, port);
    const auto size = static_cast<std::size_t>(input.descriptor->size > 0 ? input.descriptor->size : 1);
    input.values.assign(size * wires, kUnset);
    input.ages_s.assign(wires, 0);
  }
  void set(std::string_view port, std::initializer_list<double> values) {
    Port& input = find(inputs_, port);
    expects(values.size() == input.values.size());
    std::copy(values.begin(), values.end(), input.values.begin());
  }
  void set(std::string_view port, double value) { set(port, {value}); }
  void age(std::string_view port, double age_s) { find(inputs_, port).ages_s.at(0) = age_s; }
  double out(std::string_view port, std::size_t index = 0) { return find(outputs_, port).values.at(index); }

  /// All that is wired, to be filled as one likes.
  std::vector<std::span<double>> wired() {
    std::vector<std::span<double>> result;
    for (Port& input : inputs_) {
      if (!input.values.empty()) result.emplace_back(input.values);
    }
    return result;
  }

  Product& product() { return *product_; }
  const Tick& tick() const noexcept { return tick_; }

 protected:
  /// The tick that is due, `step_s` long; what the ports hold is what the component sees.
  Tick begin(double step_s) {
    if (!bound_) bind();
    tick_.step_s = step_s;
    return tick_;
  }
  void end() {
    ++tick_.number;
    tick_.time_s += tick_.step_s;
  }

 private:
  static constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
  struct Port {
    const PortDescriptor* descriptor;
    std::vector<double> values;
    std::vector<double> ages_s;
  };

  static Port& find(std::vector<Port>& ports, std::string_view name) {
    for (Port& port : ports) {
      if (port.descriptor->name == name) return port;
    }
    expects(false);
    return ports.front();
  }
  void bind() {
    for (Port& input : inputs_) views_.push_back({input.values, input.ages_s});
    for (Port& out : outputs_) spans_.emplace_back(out.values);
    product_->bind({.inputs = views_, .outputs = spans_, .stream = {.seed = 1}});
    bound_ = true;
  }

  const Descriptor& descriptor_;
  std::unique_ptr<Product> product_;
  std::vector<Port> inputs_;
  std::vector<Port> outputs_;
  std::vector<PortView> views_;
  std::vector<std::span<double>> spans_;
  Tick tick_{};
  bool bound_ = false;
};

/// A behaviour, or the lowest module of a chain, on the bench. Requests are joined by hand through product().join().
class ActingBench : public Bench<ActingModule> {
 public:
  using Bench::Bench;
  /// One tick; the last command is said to have cost 1 J and to have been carried out unless `granted` is false.
  Command step(double step_s, bool granted = true) {
    const Tick now = begin(step_s);
    product().carried_out(granted ? 1 : 0);
    product().settle(1.0);
    product().cycle(now);
    end();
    return product().command();
  }
};

class SensingBench : public Bench<SensingModule> {
 public:
  using Bench::Bench;
  void step(double step_s) {
    product().cycle(begin(step_s));
    end();
  }
};

}  // namespace ganglion::testing
