#include "ganglion/graph/testing/first.h"

#include <algorithm>
#include <array>

#include "ganglion/graph/testing/described.h"

namespace ganglion::testing {
namespace {

struct FirstConfig {
  bool generous = false;
};

constexpr std::array kPorts = {
    many(port("commands", PortRole::Candidate, "*", 0)),
    port("out", PortRole::Command, "*", 0),
    port("granted", PortRole::Output),
};
constexpr std::array kParameters = {named<FirstConfig, &FirstConfig::generous>("generous")};

class First final : public Coordinator {
 public:
  explicit First(const FirstConfig& config) : config_(config) {}

 private:
  Command coordinate(const Feedback& feedback, std::span<const Command* const> candidates,
                     std::span<double> shares) noexcept override {
    Command result;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const bool wanted = candidates[i]->kind == CommandKind::Act;
      const bool drives = wanted && result.kind != CommandKind::Act;
      if (drives) result = *candidates[i];
      shares[i] = drives || config_.generous ? 1 : 0;
    }
    put(0, feedback.granted() ? 1 : 0);
    return result;
  }

  FirstConfig config_;
};

}  // namespace

constinit const CoordinatorKind first_kind{
    {.component_class = ComponentClass::Coordinator, .name = "First", .ports = kPorts, .parameters = kParameters},
    make_bound<Coordinator, First, FirstConfig>};

}  // namespace ganglion::testing
