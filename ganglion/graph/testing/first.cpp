#include "ganglion/graph/testing/first.h"

#include <algorithm>
#include <array>

namespace ganglion::testing {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "commands", .role = PortRole::Candidate, .unit = "*", .size = 0, .many = true},
    PortDescriptor{.name = "out", .role = PortRole::Command, .unit = "*", .size = 0},
    PortDescriptor{.name = "granted", .role = PortRole::Output},
};
constexpr std::array kParameters = {ParameterDescriptor{.name = "generous", .type = ParameterType::Boolean}};

class First final : public Coordinator {
 public:
  explicit First(bool generous) : generous_(generous) {}
  static Result<std::unique_ptr<Coordinator>> make(const Parameters& parameters) {
    return std::make_unique<First>(parameters.boolean("generous"));
  }

 private:
  Command coordinate(const Feedback& feedback, std::span<const Command* const> candidates,
                     std::span<double> shares) noexcept override {
    Command result;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const bool wanted = candidates[i]->kind == CommandKind::Act;
      const bool drives = wanted && result.kind != CommandKind::Act;
      if (drives) result = *candidates[i];
      shares[i] = drives || generous_ ? 1 : 0;
    }
    put(0, feedback.granted() ? 1 : 0);
    return result;
  }

  bool generous_;
};

}  // namespace

constinit const CoordinatorKind first_kind{
    {.component_class = ComponentClass::Coordinator, .name = "First", .ports = kPorts, .parameters = kParameters},
    First::make};

}  // namespace ganglion::testing
