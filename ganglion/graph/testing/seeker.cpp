#include "ganglion/graph/testing/seeker.h"

#include <algorithm>
#include <array>

#include "ganglion/graph/testing/described.h"

namespace ganglion::testing {
namespace {

enum Input : std::size_t { kGoal, kPlace };
enum Output : std::size_t { kCycles, kAdaptations, kCharged, kGranted, kFresh, kRemembered, kTold, kOutcome };

constexpr PortDescriptor typed(PortDescriptor port, ValueType type) {
  port.type = type;
  return port;
}

/// Ports of a Seeker over `size` values of one kind.
constexpr std::array<PortDescriptor, 12> ports_of(std::string_view unit, ValueType type, int size) {
  return {{
      typed(port("goal", PortRole::Request, unit, size), type),
      typed(port("place", PortRole::Feedback, unit, size), type),
      port("step", PortRole::Command, unit, size),
      port("expected", PortRole::Appraisal, unit, size),
      port("cycles", PortRole::Output),
      port("adaptations", PortRole::Output),
      port("charged", PortRole::Output),
      port("granted", PortRole::Output),
      port("fresh", PortRole::Output),
      port("remembered", PortRole::Output),
      port("told", PortRole::Output),
      port("outcome", PortRole::Output),
  }};
}

constexpr auto kSeekerPorts = ports_of("m", ValueType::Real, 1);
constexpr auto kTurnerPorts = ports_of("rad", ValueType::Circular, 1);
constexpr auto kWalkerPorts = ports_of("", ValueType::Discrete, 2);

struct SeekerConfig {
  double stride = 1;
  bool relative = false;
  double give_up_at = 1e9;
};

constexpr std::array<std::string_view, 2> kRestsOn = {"stride", "relative"};
constexpr std::array kParameters = {
    named<SeekerConfig, &SeekerConfig::stride>("stride"),
    named<SeekerConfig, &SeekerConfig::relative>("relative"),
    named<SeekerConfig, &SeekerConfig::give_up_at>("give_up_at"),
};

class Seeker final : public ActingModule {
 public:
  explicit Seeker(const SeekerConfig& config) : config_(config) {}
  /// Fails with BadParameter unless it moves at all.
  static Result<void> judge(const SeekerConfig& config) {
    if (config.stride != 0) return {};
    return fail(ErrorCode::BadParameter, {"stride is 0, must be another number", "stride es 0, debe ser otro número"});
  }

  void grow() override { history_.reserve(std::min<std::size_t>(history_.size() + 4, 4096)); }
  std::uint32_t experience_version() const noexcept override { return 1; }
  std::span<const PartState> parts() const noexcept override { return {&steps_, 1}; }
  void copy(std::size_t, std::vector<std::byte>& into) const override {
    ByteWriter writer(std::move(into));
    for (const double step : history_) writer.f64(step);
    into = writer.take();
  }
  Result<void> load(std::uint32_t version, std::span<const ExperiencePart> parts) override {
    if (version != 1)
      return fail(ErrorCode::Unsupported, {"version {} is newer than 1", "la versión {} es más nueva que 1"}, version);
    if (parts.size() != 1 || parts[0].bytes.size() % 8 != 0)
      return fail(ErrorCode::Corrupt, {"no steps", "no hay pasos"});
    ByteReader reader(parts[0].bytes);
    history_.clear();
    for (std::size_t i = 0; i < parts[0].bytes.size() / 8; ++i) history_.push_back(reader.f64());
    ++steps_.generation;
    return {};
  }

 private:
  void internal_adaptation(const Feedback&, Cost cost) noexcept override {
    output(kAdaptations)[0] += 1;
    put(kCharged, cost.value);
  }
  Command internal_propagation(const Request& request, const Feedback& feedback) noexcept override {
    output(kCycles)[0] += 1;
    put(kGranted, feedback.granted() ? 1 : 0);
    output(kFresh)[0] += request.fresh ? 1 : 0;
    put(kTold, static_cast<double>(feedback.reason.code));
    put(kOutcome, static_cast<double>(feedback.outcome));
    const auto place = feedback[kPlace].values;
    if (place[0] >= config_.give_up_at) return Command::withdraw({ReasonCode::Trapped, place[0], request.values[0]});
    Command command = Command::act(request.values);
    for (std::size_t i = 0; i < place.size(); ++i) {
      const double step = std::clamp(request.values[i] - place[i], -config_.stride, config_.stride);
      command.values[i] = config_.relative ? step : place[i] + step;
      expected_[i] = place[i] + step;
    }
    if (history_.size() < history_.capacity()) {
      history_.push_back(command.values[0]);
      ++steps_.generation;
    }
    put(kRemembered, static_cast<double>(history_.size()));
    return command;
  }
  void expected_feedback(std::span<double> appraisal) const noexcept override {
    std::copy_n(expected_.begin(), appraisal.size(), appraisal.begin());
  }

  SeekerConfig config_;
  std::array<double, 2> expected_{};
  std::vector<double> history_;
  PartState steps_{"steps"};
};

constexpr Descriptor described(std::string_view name, std::span<const PortDescriptor> ports) {
  return {.component_class = ComponentClass::Acting,
          .name = name,
          .ports = ports,
          .parameters = kParameters,
          .rests_on = kRestsOn};
}

}  // namespace

constinit const ActingModuleKind seeker_kind{described("Seeker", kSeekerPorts),
                                             make_bound<ActingModule, Seeker, SeekerConfig>};
constinit const ActingModuleKind turner_kind{described("Turner", kTurnerPorts),
                                             make_bound<ActingModule, Seeker, SeekerConfig>};
constinit const ActingModuleKind walker_kind{described("Walker", kWalkerPorts),
                                             make_bound<ActingModule, Seeker, SeekerConfig>};

}  // namespace ganglion::testing
