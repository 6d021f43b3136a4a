#include "ganglion/link/robot/truth_teller.h"

#include <algorithm>

#include "ganglion/base/hash.h"

namespace ganglion::link {

void RowsTold::tell(const Witness& witness, int robots, wire::Sense& out) {
  const auto ledgers = witness.ledgers();
  told_.resize(static_cast<std::size_t>(robots) * ledgers.size());
  for (int robot = 0; robot < robots; ++robot) {
    for (std::size_t n = 0; n < ledgers.size(); ++n) {
      const Ledger* ledger = witness.ledger(robot, ledgers[n].task);
      out.add_done(ledger != nullptr && ledger->done());
      if (ledger == nullptr) continue;
      tell(*ledger, static_cast<std::uint32_t>(robot), static_cast<std::uint32_t>(n),
           told_[static_cast<std::size_t>(robot) * ledgers.size() + n], out);
    }
  }
}

void RowsTold::tell(const Ledger& ledger, std::uint32_t robot, std::uint32_t index, OfLedger& told, wire::Sense& out) {
  if (told.changes == ledger.changes()) return;
  told.changes = ledger.changes();
  const std::size_t columns = ledger.columns().size();
  if (ledger.rows() * columns < told.values.size()) told.values.clear();  // another episode
  for (std::size_t row = 0; row < ledger.rows(); ++row) {
    const bool fresh = row * columns == told.values.size();
    if (fresh) told.values.resize(told.values.size() + columns);
    double* known = told.values.data() + row * columns;
    bool changed = fresh;
    for (std::size_t n = 0; n < columns; ++n) {
      const double value = ledger.at(row, n);
      changed = changed || canonical_bits(value) != canonical_bits(known[n]);
      known[n] = value;
    }
    if (!changed) continue;
    wire::Row& message = *out.add_rows();
    message.set_robot(robot);
    message.set_ledger(index);
    message.set_row(static_cast<std::uint32_t>(row));
    for (std::size_t n = 0; n < columns; ++n) message.add_values(known[n]);
  }
}

void describe_truth(const Witness& witness, wire::Describe& out) {
  for (const PlacedMover& mover : witness.movers()) out.add_movers(std::string(mover.id));
  for (const TruthChannel& channel : witness.truth_channels()) {
    wire::TruthChannel& one = *out.add_truth_channels();
    one.set_name(channel.name);
    one.set_unit(channel.unit);
  }
  for (const LedgerForm& ledger : witness.ledgers()) {
    wire::Ledger& one = *out.add_ledgers();
    one.set_task(ledger.task);
    for (const LedgerColumn& column : ledger.columns) one.add_columns(column.name);
  }
}

void write_truth(const Witness& witness, int robots, wire::Sense& out) {
  for (const PlacedMover& mover : witness.movers()) {
    out.add_movers(mover.pose.position.x);
    out.add_movers(mover.pose.position.y);
    out.add_movers(mover.pose.yaw.rad());
  }
  for (int robot = 0; robot < robots; ++robot) {
    for (const double value : witness.truth_of(robot)) out.add_truth_values(value);
  }
}

}  // namespace ganglion::link
