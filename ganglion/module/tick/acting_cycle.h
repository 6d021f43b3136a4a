#pragma once

#include <optional>
#include <span>

#include "ganglion/module/tick/feedback.h"
#include "ganglion/module/tick/request.h"

namespace ganglion {

/// How an acting module is joined to what is above and below it.
struct ActingLinks {
  RequestSlot* request = nullptr;  ///< Its own request; none = a behaviour that needs no request.
  RequestSlot* below = nullptr;    ///< Where its commands become requests; none = they go to the application.
  /// The request its commands end in where coordinators stand in between; none = `below`, or the application.
  const RequestSlot* answer = nullptr;
  std::size_t satisfied_by = 0;  ///< The input that is held against what is sought: the first Feedback port.
  Comparison comparison{};
  std::span<const ReasonCode> likes{};  ///< Of each of its kind's own reasons the common one it is a case of.
};

/// The cycle of an acting module and its order; a kind fills in the two steps that make it what it is. It takes no
/// memory and knows no text, so that it serves a microcontroller as well.
///
/// Source    "A growing functional modules locomotion subsystem", section 1, figure 2 and Algorithm 1.
/// Differs   One pass of the paper's inner loop is a tick; satisfaction is found by settle(), before the goals decide,
///           so that a hand-over wastes no tick; a behaviour in the sense of Brooks is a module without a request port.
///           Standing requests (set-points) and what is sought where it is not the request itself are ours.
class ActingCycle {
 public:
  virtual ~ActingCycle() = default;

  /// Where its readings come from and where its expectation goes: once, before the first tick.
  void see(std::span<const PortView> inputs, std::span<double> appraisal) noexcept {
    inputs_ = inputs;
    appraisal_ = appraisal;
  }
  void join(const ActingLinks& links) noexcept { joints_ = links; }
  /// Its commands become requests of a module below.
  void set_below(RequestSlot* below) noexcept { joints_.below = below; }
  /// Its commands may become requests of a module below, if a coordinator lets them.
  void set_answer(const RequestSlot* answer) noexcept { joints_.answer = answer; }

  /// Upward sweep: adds up what the last command cost and finds the request satisfied or not, or satisfied no more.
  /// `frame_cost` is the application's; a module above others sees the sum of theirs instead.
  void settle(std::optional<double> frame_cost) noexcept;
  /// True while the last command is still being carried out below: this tick has no cycle.
  bool waits() const noexcept;
  /// Downward sweep: the paper's cycle. Sends the command below, or leaves it in command() for others to fetch.
  void cycle(const Tick& tick) noexcept;

  const Command& command() const noexcept { return command_; }
  /// What settle() found the last command to have cost; none = unknown, not carried out, or still under way below.
  const std::optional<double>& last_cost() const noexcept { return last_cost_; }
  /// Told what part of the command of this tick was carried out: see Feedback::share.
  void carried_out(double share) noexcept { share_ = share; }
  /// Of a standing request: whether it was held when last looked at.
  bool is_settled() const noexcept { return settled_; }

 protected:
  /// Fits the module to what its last command brought about. Only called when that command was carried out, whole and
  /// alone, and its cost is known.
  virtual void internal_adaptation(const Feedback& feedback, Cost cost) noexcept = 0;
  /// Chooses the next command. Of a module with a request port only called while a request is pending.
  virtual Command internal_propagation(const Request& request, const Feedback& feedback) noexcept = 0;
  /// What the first Feedback port must equal, asked once, when a request is fresh, with the feedback of that tick. By
  /// default the request itself: a module that translates it (a direction into a cell) says what it means.
  virtual void seek(const Request& fresh, const Feedback& feedback, Sought& into) const noexcept;
  /// Of a standing request, asked at every tick: whether it counts as held. By default while the first Feedback port is
  /// within the tolerance of what is sought.
  virtual bool settled(const Request& request, const Feedback& feedback) const noexcept;
  /// The perception expected at the next tick, for the sensing modules wired to it; NaN = no expectation.
  virtual void expected_feedback(std::span<double> appraisal) const noexcept;

 private:
  bool standing() const noexcept { return joints_.request != nullptr && joints_.request->standing; }
  /// The last command is still under way below: in a cycle this means that a new request broke it off.
  bool interrupted() const noexcept;
  Request get_request() noexcept;
  Feedback get_feedback(const Tick& tick) const noexcept;
  std::optional<Cost> get_cost() const noexcept;
  void settle_request() noexcept;
  bool holds_no_more() const noexcept;
  Command unasked() const noexcept;
  void send_appraisal() const noexcept;
  void send_command(const Command& command) noexcept;
  void send_below() noexcept;

  std::span<const PortView> inputs_{};
  std::span<double> appraisal_{};
  ActingLinks joints_{};
  Command command_{};
  Sought sought_{};
  std::optional<double> last_cost_;
  std::uint32_t seen_serial_ = 0;
  double share_ = 1;
  bool settled_ = false;
};

}  // namespace ganglion
