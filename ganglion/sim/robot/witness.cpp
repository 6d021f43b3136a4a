#include "ganglion/sim/robot/witness.h"

#include "ganglion/sim/robot/truth_channels.h"

namespace ganglion::sim {

std::span<const TruthChannel> Witness::truth_channels() const noexcept { return sim::truth_channels(); }

std::span<const double> Witness::truth_of(int robot) const noexcept {
  const auto index = static_cast<std::size_t>(robot);
  if (rows_.size() <= index) rows_.resize(index + 1);
  std::vector<double>& row = rows_[index];
  if (row.empty()) row.resize(sim::truth_channels().size());
  write_truth(truth(robot), row);
  return row;
}

const Ledger* Witness::goals_of(int robot) const noexcept {
  const TrainerLog* log = trainer_log(robot);
  if (log == nullptr) return nullptr;
  const auto index = static_cast<std::size_t>(robot);
  if (ledgers_.size() <= index) ledgers_.resize(index + 1);
  std::optional<TrainerLedger>& ledger = ledgers_[index];
  if (!ledger || ledger->source() != log) ledger.emplace(*log);
  return &*ledger;
}

}  // namespace ganglion::sim
