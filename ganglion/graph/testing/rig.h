#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "ganglion/graph/controller.h"
#include "ganglion/graph/testing/kinds.h"
#include "ganglion/graph/testing/pieces.h"

namespace ganglion::testing {

/// A robot to draw controllers for: sensations place [m], heading [rad], cell {column, row}, pair {x, y} and the plain
/// numbers a, b, c, d; commands drive {left, right} in [-1, 1], move {x} in [-10, 10] and grip {force} in [0, 5], safe
/// at 2.
Description test_robot();

/// Reads, resolves and compiles a controller file's text, with `format = 1` put before it as line 1.
Result<Controller> compiled(std::string_view text, Problems& problems, const Description& robot = test_robot(),
                            const Identity& identity = {});
/// Every problem of a controller file, one a line: "controller.toml:line:column: ...". The text begins at line 2.
std::string problems_of(std::string_view text);

/// A controller whose frames are fed by hand.
class Rig {
 public:
  /// Stops the program where the text has problems: they are printed.
  explicit Rig(std::string_view text, const Identity& identity = {});

  void set(std::string_view channel, std::initializer_list<double> values);
  void set(std::string_view channel, double value) { set(channel, {value}); }
  void age(std::string_view channel, double age_s);
  /// One frame in, one out, 0.1 s after the last. Ticks count from 1.
  void tick();
  void tick(int times) {
    for (int i = 0; i < times; ++i) tick();
  }

  double signal(std::string_view name) const;
  /// The digest of one component.
  std::uint64_t digest(std::string_view id) const;
  double command(std::string_view channel, std::size_t element = 0) const;
  CommandOrigin origin(std::string_view channel) const { return act.origins[channel_index(channel)]; }
  ReasonCode reason(std::string_view channel) const {
    return static_cast<ReasonCode>(act.reasons[channel_index(channel)]);
  }
  double ttl_s(std::string_view channel) const { return act.ttl_s[channel_index(channel)]; }
  int index(std::string_view id) const;

  std::optional<double> cost;  ///< Of the next frame.
  SenseFrame sense;
  ActFrame act;
  Controller controller;

 private:
  std::size_t channel_index(std::string_view channel) const;
  Description robot_;
};

}  // namespace ganglion::testing
