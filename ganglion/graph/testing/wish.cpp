#include "ganglion/graph/testing/wish.h"

#include <array>

namespace ganglion::testing {
namespace {

enum Input : std::size_t { kWanted, kWishInput, kStrength, kRank };
enum Output : std::size_t { kBids, kSatisfied, kWithdrawn, kReason };

constexpr std::array kPorts = {
    PortDescriptor{.name = "wanted", .role = PortRole::Feedback, .unit = "*", .required = false},
    PortDescriptor{.name = "wish", .role = PortRole::Feedback, .unit = "*", .size = 0, .required = false},
    PortDescriptor{.name = "strength", .role = PortRole::Feedback, .unit = "*", .required = false},
    PortDescriptor{.name = "rank", .role = PortRole::Feedback, .unit = "*", .required = false},
    PortDescriptor{.name = "bids", .role = PortRole::Output},
    PortDescriptor{.name = "satisfied", .role = PortRole::Output},
    PortDescriptor{.name = "withdrawn", .role = PortRole::Output},
    PortDescriptor{.name = "reason", .role = PortRole::Output},
};

constexpr std::array kParameters = {
    ParameterDescriptor{.name = "values", .type = ParameterType::Reals},
    ParameterDescriptor{.name = "class", .type = ParameterType::Integer},
    ParameterDescriptor{.name = "intensity", .preset = 1},
    ParameterDescriptor{.name = "replaces", .type = ParameterType::Boolean},
};

class Wish final : public GlobalGoal {
 public:
  explicit Wish(const Parameters& parameters)
      : values_(parameters.reals("values").begin(), parameters.reals("values").end()),
        class_(parameters.integer("class")),
        intensity_(parameters.real("intensity")),
        replaces_(parameters.boolean("replaces")) {}
  static Result<std::unique_ptr<GlobalGoal>> make(const Parameters& parameters) {
    return std::make_unique<Wish>(parameters);
  }
  void concluded(RequestStatus status, const Reason& reason) noexcept override {
    output(status == RequestStatus::Satisfied ? kSatisfied : kWithdrawn)[0] += 1;
    put(kReason, static_cast<double>(reason.code));
  }

 private:
  Bid bid(const Feedback& feedback) noexcept override {
    output(kBids)[0] += 1;
    if (feedback[kWanted].wired() && !(feedback.value(kWanted) > 0)) return {};
    Bid bid{values_, class_, intensity_, replaces_};
    if (feedback[kWishInput].wired()) bid.values = feedback[kWishInput].values;
    if (feedback[kStrength].wired()) bid.intensity = feedback.value(kStrength);
    if (feedback[kRank].wired()) bid.priority_class = static_cast<int>(feedback.value(kRank));
    return bid;
  }

  std::vector<double> values_;
  int class_;
  double intensity_;
  bool replaces_;
};

}  // namespace

constinit const GlobalGoalKind wish_kind{
    {.component_class = ComponentClass::Goal, .name = "Wish", .ports = kPorts, .parameters = kParameters}, Wish::make};

}  // namespace ganglion::testing
