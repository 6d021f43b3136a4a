#pragma once

#include <vector>

#include "ganglion/task/task.h"

namespace ganglion {

struct HoldConfig {
  std::vector<double> values{1};  ///< Set-points in order.
  double each_s = 10;             ///< How long each is asked for.
  bool again = false;             ///< From the first once all were asked for.
};

/// Asks for set-points, one after the other, each for the same time: the reference of a closed loop.
///
/// Channel `setpoint`  the value wanted, in the plant's own unit.
/// Channel `left_s` [s]  how long it is still asked for; +inf for the last.
/// Keeps a row for each: when it was set, and its value. Needs no ground, and nothing of the truth. Ours.
class Hold final : public Task {
 public:
  explicit Hold(HoldConfig config) : config_(std::move(config)) {}
  /// Fails with BadParameter without values.
  static Result<void> judge(HoldConfig& config);

  Limits limits(std::size_t channel) const noexcept override;
  LedgerForm form() const override { return Steps::form(); }
  Result<void> begin(const Outlook& now, Draws draws) override;
  void judge(const Outlook& now) noexcept override;
  void tell(const Outlook& now, std::span<double> values) const noexcept override;
  const Ledger* ledger() const noexcept override { return &steps_; }

  static constexpr std::size_t kMaxValues = 1000;

 private:
  struct Step {
    double time_s = 0;
    double setpoint = 0;
  };
  class Steps final : public Ledger {
   public:
    static LedgerForm form();
    std::span<const LedgerColumn> columns() const noexcept override;
    std::size_t rows() const noexcept override { return list.size(); }
    double at(std::size_t row, std::size_t column) const noexcept override {
      return column == 0 ? list[row].time_s : list[row].setpoint;
    }
    bool done() const noexcept override { return all_set; }
    std::uint64_t changes() const noexcept override { return changed; }

    std::vector<Step> list;
    bool all_set = false;
    std::uint64_t changed = 0;
  };
  /// Which value is asked for at that time, counted from 0 without end.
  std::size_t turn(double time_s) const noexcept;
  bool last(std::size_t turn) const noexcept { return !config_.again && turn + 1 >= config_.values.size(); }
  double value(std::size_t turn) const noexcept { return config_.values[turn % config_.values.size()]; }

  HoldConfig config_;
  std::size_t turn_ = 0;
  Steps steps_;
};

}  // namespace ganglion
