#include "ganglion/graph/testing/wish.h"

#include <array>

#include "ganglion/graph/testing/described.h"

namespace ganglion::testing {
namespace {

enum Input : std::size_t { kWanted, kWishInput, kStrength };
enum Output : std::size_t { kBids, kSatisfied, kWithdrawn, kReason };

constexpr std::array kPorts = {
    optional(port("wanted", PortRole::Feedback, "*")),
    optional(port("wish", PortRole::Feedback, "*", 0)),
    optional(port("strength", PortRole::Feedback, "*")),
    port("bids", PortRole::Output),
    port("satisfied", PortRole::Output),
    port("withdrawn", PortRole::Output),
    port("reason", PortRole::Output),
};

struct WishConfig {
  std::vector<double> values;
  double intensity = 1;
  bool replaces = false;
  bool once = false;
};

constexpr std::array kParameters = {
    named<WishConfig, &WishConfig::values>("values"),
    named<WishConfig, &WishConfig::intensity>("intensity"),
    named<WishConfig, &WishConfig::replaces>("replaces"),
    named<WishConfig, &WishConfig::once>("once"),
};

class Wish final : public GlobalGoal {
 public:
  explicit Wish(WishConfig config) : config_(std::move(config)) {}
  void concluded(RequestStatus status, const Reason& reason) noexcept override {
    output(status == RequestStatus::Satisfied ? kSatisfied : kWithdrawn)[0] += 1;
    put(kReason, static_cast<double>(reason.code));
  }

 private:
  Bid bid(const Feedback& feedback) noexcept override {
    output(kBids)[0] += 1;
    if (feedback[kWanted].wired() && !(feedback.value(kWanted) > 0)) return {};
    Bid bid{config_.values, config_.intensity, config_.replaces, config_.once};
    if (feedback[kWishInput].wired()) bid.values = feedback[kWishInput].values;
    if (feedback[kStrength].wired()) bid.intensity = feedback.value(kStrength);
    return bid;
  }

  WishConfig config_;
};

}  // namespace

constinit const GlobalGoalKind wish_kind{
    {.component_class = ComponentClass::Goal, .name = "Wish", .ports = kPorts, .parameters = kParameters},
    make_bound<GlobalGoal, Wish, WishConfig>};

}  // namespace ganglion::testing
