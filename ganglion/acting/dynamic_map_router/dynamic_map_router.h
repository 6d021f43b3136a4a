#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "ganglion/acting/dynamic_map_router/trail.h"
#include "ganglion/grid/risk_map.h"
#include "ganglion/grid/router.h"
#include "ganglion/module/acting_module.h"

namespace ganglion {

/// What secure routes minimise.
enum class SecureBy { Cost, Length };

/// The ranges of its values are those of the kind's parameters.
struct DynamicMapRouterConfig {
  double cell_m = 0.5;                  ///< Side of a cell: the robot's largest dimension.
  int max_turn_deg = 45;                ///< Most that one step may turn the heading; see DynamicMapRouter::judge().
  int max_tiles = 64;                   ///< Of 64 x 64 cells, 128 KiB each.
  SecureBy secure_by = SecureBy::Cost;  ///< See DynamicMapRouter::judge().
  grid::RiskRule risk{};
  grid::PriceRule price{};
  grid::RouterRule router{};
  int dynamic_tries = 3;  ///< Attempts that a dynamic cell gets in one round; a static one gets one.
  int go_back_steps = 50;
  int rounds = 3;
  double patience_s = 5;  ///< Without knowing the cell.
};

/// Maps the ground while driving over it, and routes the robot to a requested cell (AmDmr in the GFM papers).
///
/// Request   goal cell {column, row}.
/// Feedback  cell reached {column, row}, heading [rad]; optional: position [m], contact, direction of the goal [rad].
/// Command   {motion, direction}: 1 forward or -1 backward; direction of travel, a multiple of 45 deg in the map's
///           frame. Withdraw (unreachable, trapped, outside the map, bad request, no reading) once everything has
///           failed, or for the reason of the module below when that one cannot drive at all.
/// Memory    the map grows tile by tile between ticks up to max_tiles; then ground outside it is closed. A tick
///           allocates nothing.
/// Ticks     of inhibitions are cycles of this module: while a step is carried out below, none pass.
/// Source    "A growing functional modules locomotion subsystem", Methodology 1, Algorithm 2.
/// Differs   The paper's two definitions of reliance become one risk; its numbers are lost, so all are ours. A round
///           gives each cell a limited number of attempts, or else a sealed goal would be besieged for ever. A failed
///           diagonal step is blamed on the likeliest of its three cells. A step without contact that does not arrive
///           fails as well, but counts for half an attempt. While several unexplored cells may be to blame, none is
///           called occupied. Unexplored ground is priced by what stands around it (UnexploredRule), not free. A robot
///           that reports no cost maps all the same.
class DynamicMapRouter final : public ActingModule {
 public:
  enum class Phase { Idle, Secure, Feasible, GoBack, Wait };
  /// Inputs and outputs in the order of the descriptor.
  enum Input : std::size_t { kGoal, kCell, kPosition, kHeading, kContact, kGoalDirection };
  enum Output : std::size_t {
    kRiskAhead,
    kRouteLength,
    kPhase,
    kExplored,
    kOccupied,
    kFailures,
    kRounds,
    kGoalDistance,
    kGoalError
  };

  explicit DynamicMapRouter(const DynamicMapRouterConfig& config);
  /// Works out router.max_turn of max_turn_deg, and price.secure_weighs_cost of secure_by. Fails never.
  static Result<void> judge(DynamicMapRouterConfig& config);

  void grow() override;
  std::span<const Command> plan() const noexcept override;
  void show(Exhibition& exhibition) const override;
  std::uint32_t experience_version() const noexcept override { return 2; }
  std::span<const PartState> parts() const noexcept override { return map_.parts(); }
  void copy(std::size_t part, std::vector<std::byte>& into) const override { map_.copy(part, into); }
  Result<void> load(std::uint32_t version, std::span<const ExperiencePart> parts) override;

  const grid::RiskMap& map() const noexcept { return map_; }
  Phase phase() const noexcept { return phase_; }

 private:
  /// A step that failed: from where, and what is to blame.
  struct Tried {
    grid::CellIndex from{}, to{};
  };

  void internal_adaptation(const Feedback& feedback, Cost cost) noexcept override;
  Command internal_propagation(const Request& request, const Feedback& feedback) noexcept override;
  void expected_feedback(std::span<double> appraisal) const noexcept override;

  // Adaptation: what the last step brought about.
  void attend(const Feedback& feedback, double cost_j) noexcept;
  void locate(const Feedback& feedback) noexcept;
  /// `untouched`: the robot has a contact sensor, and it felt nothing.
  void conclude_attempt(bool untouched) noexcept;
  void note_arrival(const grid::RouteStep& step) noexcept;
  void note_failure(const grid::RouteStep& step, bool untouched) noexcept;

  // Propagation: the next step.
  void accept(std::span<const double> request) noexcept;
  Command decide(const Request& request, const Feedback& feedback) noexcept;
  Command hold(const Feedback& feedback) noexcept;
  Command retreat() noexcept;
  Command follow_route() noexcept;
  Command go(const grid::RouteStep& step) noexcept;
  Command give_up(Reason reason) noexcept;
  bool keeps_route() const noexcept;
  bool finds_route() noexcept;
  bool outside_map() const noexcept;
  bool trapped() const noexcept;
  bool can_turn_to(int heading) const noexcept;
  void take_route() noexcept;
  void drop_route() noexcept;
  grid::Pricing pricing(Phase phase) const noexcept;
  void publish(Phase phase, const Feedback& feedback) const noexcept;
  void publish_goal(const Feedback& feedback) const noexcept;

  void show_map(Exhibition& exhibition) const;
  void show_route(Exhibition& exhibition) const;
  void show_attempts(Exhibition& exhibition) const;

  DynamicMapRouterConfig config_;
  grid::RiskMap map_;
  grid::Router router_;
  Trail trail_;

  // Where the robot is, as far as known.
  std::optional<grid::CellIndex> cell_;
  std::optional<int> heading_;  ///< In eighths of a turn.
  bool cell_read_ = false;      ///< In this tick.

  // The step under way, whose outcome is not known yet.
  std::optional<grid::RouteStep> attempt_;
  double attempt_cost_j_ = 0;
  bool attempt_costed_ = false;

  // The request and how far it got.
  std::optional<grid::CellIndex> goal_;
  Phase phase_ = Phase::Idle;
  std::size_t next_ = 0;           ///< Step of the route to be driven now.
  std::vector<Command> commands_;  ///< The route as commands.
  int rounds_ = 0;
  int failures_ = 0;
  std::array<Tried, 64> tried_{};  ///< The last failures of all requests, each at its remainder.
  std::size_t attempts_ = 0;       ///< That failed, of all requests.
  bool no_route_ = false;          ///< Nothing was found, and nothing has changed since.
  std::uint32_t no_route_revision_ = 0;
  std::optional<std::uint32_t> no_route_until_;

  std::uint32_t now_ = 0;  ///< Cycles so far.
  std::optional<std::uint32_t> attended_;
  std::optional<double> silent_since_s_;
};

}  // namespace ganglion
