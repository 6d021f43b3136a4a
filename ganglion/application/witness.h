#pragma once

#include <span>
#include <string>
#include <vector>

#include "ganglion/base/sentence.h"

namespace ganglion {

/// One value that is true of a robot or plant, whatever its sensors say: for digests, measures and pictures.
struct TruthChannel {
  std::string name;  ///< "x_m", recorded as "truth.x_m"
  std::string unit;
  Sentence title;
  bool digested = false;  ///< It is in the run's digest, in the order of the channels.
};

/// A column of a Ledger.
struct LedgerColumn {
  std::string name;
  std::string unit;
};

/// What somebody keeps of things that follow each other, as rows of named numbers: a trainer of its goals.
class Ledger {
 public:
  virtual ~Ledger() = default;
  virtual std::span<const LedgerColumn> columns() const noexcept = 0;
  virtual std::size_t rows() const noexcept = 0;
  virtual double at(std::size_t row, std::size_t column) const noexcept = 0;
  /// Nothing is open any more, and nothing comes.
  virtual bool done() const noexcept = 0;
};

/// What is known of an application besides what its sensations say. A simulation knows it; a link may carry it on; of a
/// real robot nobody does.
class Witness {
 public:
  virtual ~Witness() = default;
  virtual std::span<const TruthChannel> truth_channels() const noexcept = 0;
  /// One value for each channel, as they are now. Valid until the application goes on.
  virtual std::span<const double> truth_of(int robot) const noexcept = 0;
  /// What the robot's trainer keeps of its goals; null if it has none.
  virtual const Ledger* goals_of(int robot) const noexcept = 0;
};

}  // namespace ganglion
