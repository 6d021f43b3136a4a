#pragma once

#include <span>
#include <vector>

#include "ganglion/application/witness.h"
#include "ganglion/link/wire/link.pb.h"

namespace ganglion::link {

/// What one listener was told of the ledgers, so that a frame carries only rows that changed.
class RowsTold {
 public:
  /// Adds the rows of which the listener does not know the present state, and whether more come.
  void tell(const Witness& witness, int robots, wire::Sense& out);

 private:
  struct OfLedger {
    std::uint64_t changes = ~std::uint64_t{0};
    std::vector<double> values;  // as they were told, row by row
  };
  static void tell(const Ledger& ledger, std::uint32_t robot, std::uint32_t index, OfLedger& told, wire::Sense& out);

  std::vector<OfLedger> told_;
};

/// What can be told, once.
void describe_truth(const Witness& witness, wire::Describe& out);
/// All but the ledgers' rows.
void write_truth(const Witness& witness, int robots, wire::Sense& out);

}  // namespace ganglion::link
