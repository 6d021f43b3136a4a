#include "ganglion/graph/testing/sensing_kinds.h"

#include <array>

#include "ganglion/graph/testing/described.h"

namespace ganglion::testing {
namespace {

struct GainConfig {
  double gain = 1;
};

constexpr std::array kGainPorts = {
    port("in", PortRole::Feedback, "*"),
    port("out", PortRole::Output),
};
constexpr std::array kGainParameters = {named<GainConfig, &GainConfig::gain>("gain")};

class Gain final : public SensingModule {
 public:
  explicit Gain(const GainConfig& config) : config_(config) {}

 private:
  void perceive(const Feedback& feedback) noexcept override { put(0, config_.gain * feedback.value(0)); }
  GainConfig config_;
};

constexpr std::array kCopyPorts = {
    port("in", PortRole::Feedback, "*", 0),
    port("out", PortRole::Output, "*", 0),
};

class Copy final : public SensingModule {
 public:
  static Result<std::unique_ptr<SensingModule>> make(const Parameters&) { return std::make_unique<Copy>(); }

 private:
  void perceive(const Feedback& feedback) noexcept override {
    const std::size_t count = std::min(output(0).size(), feedback[0].values.size());
    for (std::size_t i = 0; i < count; ++i) output(0)[i] = feedback[0].values[i];
  }
};

constexpr std::array kSurprisePorts = {
    port("in", PortRole::Feedback, "*"),
    optional(port("expected", PortRole::Appraisal, "*")),
    port("error", PortRole::Output),
    port("heard", PortRole::Output),
};

class Surprise final : public SensingModule {
 public:
  static Result<std::unique_ptr<SensingModule>> make(const Parameters&) { return std::make_unique<Surprise>(); }

 private:
  void perceive(const Feedback& feedback) noexcept override {
    put(0, feedback.value(0) - feedback.value(1));
    put(1, feedback.value(1));
  }
};

constexpr std::array kSumPorts = {
    many(port("in", PortRole::Feedback, "*")),
    port("out", PortRole::Output),
};

class Sum final : public SensingModule {
 public:
  static Result<std::unique_ptr<SensingModule>> make(const Parameters&) { return std::make_unique<Sum>(); }

 private:
  void perceive(const Feedback& feedback) noexcept override {
    double sum = 0;
    for (const double value : feedback[0].values) sum += value;
    put(0, sum);
  }
};

constexpr std::array kAgePorts = {
    port("in", PortRole::Feedback, "*"),
    port("out", PortRole::Output, "s"),
};

class AgeOf final : public SensingModule {
 public:
  static Result<std::unique_ptr<SensingModule>> make(const Parameters&) { return std::make_unique<AgeOf>(); }

 private:
  void perceive(const Feedback& feedback) noexcept override { put(0, feedback[0].ages_s[0]); }
};

constexpr std::array kNoisePorts = {port("out", PortRole::Output)};

class Noise final : public SensingModule {
 public:
  static Result<std::unique_ptr<SensingModule>> make(const Parameters&) { return std::make_unique<Noise>(); }

 private:
  void perceive(const Feedback& feedback) noexcept override { put(0, draws(feedback.tick).uniform()); }
};

template <std::size_t Ports>
constexpr Descriptor described(std::string_view name, const std::array<PortDescriptor, Ports>& ports,
                               std::span<const ParameterDescriptor> parameters = {}) {
  return {.component_class = ComponentClass::Sensing, .name = name, .ports = ports, .parameters = parameters};
}

}  // namespace

constinit const SensingModuleKind gain_kind{described("Gain", kGainPorts, kGainParameters),
                                            make_bound<SensingModule, Gain, GainConfig>};
constinit const SensingModuleKind copy_kind{described("Copy", kCopyPorts), Copy::make};
constinit const SensingModuleKind surprise_kind{described("Surprise", kSurprisePorts), Surprise::make};
constinit const SensingModuleKind sum_kind{described("Sum", kSumPorts), Sum::make};
constinit const SensingModuleKind age_of_kind{described("AgeOf", kAgePorts), AgeOf::make};
constinit const SensingModuleKind noise_kind{described("Noise", kNoisePorts), Noise::make};

}  // namespace ganglion::testing
