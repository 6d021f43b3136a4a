#pragma once

#include <optional>

#include "ganglion/module/component.h"
#include "ganglion/module/request.h"

namespace ganglion {

/// How the graph joins an acting module to what is above and below it.
struct ActingLinks {
  RequestSlot* request = nullptr;  ///< Its own request; none = a behaviour that needs no request.
  RequestSlot* below = nullptr;    ///< Where its commands become requests; none = they go to the application.
  /// The request its commands end in where coordinators stand in between; none = `below`, or the application.
  const RequestSlot* answer = nullptr;
  std::size_t satisfied_by = 0;  ///< The input that requests are compared with: the first Feedback port.
  double tolerance = 0;          ///< Of that comparison.
  bool circular = false;
};

/// A functionality acquired while acting (orange in the GFM papers). The base class owns the cycle and its order; a
/// kind fills in the two steps that make it what it is.
///
/// Source    "A growing functional modules locomotion subsystem", section 1, figure 2 and Algorithm 1.
/// Differs   One pass of the paper's inner loop is a tick; satisfaction is found by settle(), before the goals decide,
///           so that a hand-over wastes no tick; a behaviour in the sense of Brooks is a module without a request port.
class ActingModule : public Component {
 public:
  void join(const ActingLinks& links) noexcept { joints_ = links; }
  /// Its commands become requests of a module below.
  void set_below(RequestSlot* below) noexcept { joints_.below = below; }
  /// Its commands may become requests of a module below, if a coordinator lets them.
  void set_answer(const RequestSlot* answer) noexcept { joints_.answer = answer; }

  /// Upward sweep: adds up what the last command cost and finds the request satisfied or not.
  /// `frame_cost` is the application's; a module above others sees the sum of theirs instead.
  void settle(std::optional<double> frame_cost) noexcept;
  /// True while the last command is still being carried out below: this tick has no cycle.
  bool waits() const noexcept;
  /// Downward sweep: the paper's cycle. Sends the command below, or leaves it in command() for others to fetch.
  void cycle(const Tick& tick) noexcept;

  const Command& command() const noexcept { return command_; }
  /// What settle() found the last command to have cost; none = unknown, not carried out, or still under way below.
  const std::optional<double>& last_cost() const noexcept { return last_cost_; }
  /// Told by a coordinator whether the command of this tick was carried out.
  void grant(bool granted) noexcept { granted_ = granted; }
  /// The sequence of commands planned, the first of which was sent; for onlookers.
  virtual std::span<const Command> plan() const noexcept { return {}; }

 protected:
  /// Fits the module to what its last command brought about. Only called when that command was carried out and its
  /// cost is known.
  virtual void internal_adaptation(const Feedback& feedback, Cost cost) noexcept = 0;
  /// Chooses the next command. Of a module with a request port only called while a request is pending.
  virtual Command internal_propagation(const Request& request, const Feedback& feedback) noexcept = 0;
  /// The perception expected at the next tick, for the sensing modules wired to it; NaN = no expectation.
  virtual void expected_feedback(std::span<double> appraisal) const noexcept;

 private:
  /// The last command is still under way below: in a cycle this means that a new request broke it off.
  bool interrupted() const noexcept;
  Request get_request() noexcept;
  Feedback get_feedback(const Tick& tick) const noexcept;
  std::optional<Cost> get_cost() const noexcept;
  Command unasked() const noexcept;
  void send_appraisal() const noexcept;
  void send_command(const Command& command) noexcept;

  ActingLinks joints_{};
  Command command_{};
  std::optional<double> last_cost_;
  std::uint32_t seen_serial_ = 0;
  bool granted_ = true;
};

using ActingModuleKind = Kind<ActingModule>;

}  // namespace ganglion
