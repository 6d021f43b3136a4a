#pragma once

#include "ganglion/application/witness.h"
#include "ganglion/sim/robot/trainer_log.h"

namespace ganglion::sim {

/// A trainer's goals as rows of named numbers.
class TrainerLedger final : public Ledger {
 public:
  explicit TrainerLedger(const TrainerLog& log) noexcept : log_(&log) {}
  std::span<const LedgerColumn> columns() const noexcept override { return columns_of_goals(); }
  std::size_t rows() const noexcept override { return log_->records().size(); }
  double at(std::size_t row, std::size_t column) const noexcept override;
  bool done() const noexcept override { return log_->done(); }
  const TrainerLog* source() const noexcept { return log_; }

  static std::span<const LedgerColumn> columns_of_goals() noexcept;

 private:
  const TrainerLog* log_;
};

}  // namespace ganglion::sim
