#pragma once

#include <string>
#include <vector>

#include "ganglion/application/witness.h"
#include "ganglion/base/result.h"
#include "ganglion/link/wire/link.pb.h"

namespace ganglion::link {

/// What a controller knows of an application from its file, and hopes to be told of over the link.
struct HopedTruth {
  std::vector<TruthChannel> channels;
  std::vector<LedgerForm> ledgers;
};

/// The truth about robots as it came over the link: the channels and ledgers of the file, whatever else the other side
/// tells. A channel that it does not tell is NaN; a ledger that it does not tell, or has other columns for, is none.
class RemoteWitness final : public Witness {
 public:
  /// Whether the other side tells any truth that this can take; one of version 1.0 does not.
  static bool told(const wire::Describe& describe);
  /// Fails with TooLarge or BadParameter where what is described is beyond the limits.
  static Result<RemoteWitness> make(const wire::Describe& describe, HopedTruth hoped);
  /// Takes the truth of a frame; the first one of an episode begins its ledgers anew. Fails with BadParameter where it
  /// is not as described.
  Result<void> take(const wire::Sense& sense, double time_s, bool first);

  std::span<const TruthChannel> truth_channels() const noexcept override { return hoped_.channels; }
  std::span<const double> truth_of(int robot) const noexcept override;
  double time_s() const noexcept override { return time_s_; }
  std::span<const LedgerForm> ledgers() const noexcept override { return hoped_.ledgers; }
  const Ledger* ledger(int robot, std::string_view task) const noexcept override;
  std::span<const PlacedMover> movers() const noexcept override { return movers_; }

 private:
  class Copy final : public Ledger {
   public:
    explicit Copy(std::span<const LedgerColumn> columns) noexcept : columns_(columns) {}
    std::span<const LedgerColumn> columns() const noexcept override { return columns_; }
    std::size_t rows() const noexcept override { return columns_.empty() ? 0 : values_.size() / columns_.size(); }
    double at(std::size_t row, std::size_t column) const noexcept override {
      return values_[row * columns_.size() + column];
    }
    bool done() const noexcept override { return done_; }
    std::uint64_t changes() const noexcept override { return changes_; }
    void clear() noexcept { values_.clear(), done_ = false, ++changes_; }
    void set_done(bool done) noexcept { changes_ += done != done_ ? 1 : 0, done_ = done; }
    /// Fails where the row comes too early.
    bool set(std::size_t row, std::span<const double> values);

   private:
    std::span<const LedgerColumn> columns_;
    std::vector<double> values_;
    bool done_ = false;
    std::uint64_t changes_ = 0;
  };
  /// One that the other side keeps.
  struct Told {
    std::size_t columns = 0;
    int hoped = -1;                  ///< Index of the ledger it is here; -1 = of no use.
    std::vector<std::size_t> order;  ///< For each column here the one there.
  };

  RemoteWitness() = default;
  Result<void> take_rows(const wire::Sense& sense);
  std::size_t copies() const noexcept { return hoped_.ledgers.size(); }

  HopedTruth hoped_;
  std::size_t robots_ = 1;
  std::size_t told_channels_ = 0;
  std::vector<int> channel_;    // for each here the one there, or -1
  std::vector<double> values_;  // of all robots
  std::vector<Told> told_;
  std::vector<Copy> copies_;  // robot by robot
  std::vector<double> row_;
  std::size_t rows_taken_ = 0;  // of all copies, in this episode
  std::vector<std::string> mover_ids_;
  std::vector<PlacedMover> movers_;
  double time_s_ = 0;
};

}  // namespace ganglion::link
