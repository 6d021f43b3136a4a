#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/application/ledger.h"
#include "ganglion/base/sentence.h"
#include "ganglion/geometry/pose2.h"

namespace ganglion {

/// One value that is true of a robot or plant, whatever its sensors say: for digests, measures and pictures.
struct TruthChannel {
  std::string name;  ///< "x_m", recorded as "truth.x_m"
  std::string unit;
  Sentence title;
  bool digested = false;  ///< It is in the run's digest, in the order of the channels.
};

/// Index of a channel; none where there is no such.
std::optional<std::size_t> index_of(std::span<const TruthChannel> channels, std::string_view name) noexcept;

/// Something that moves about beside the robots, as it stands now.
struct PlacedMover {
  std::string_view id;
  Pose2 pose{};
};

/// What is known of an application besides what its sensations say. A simulation knows it; a link may carry it on; of a
/// real robot nobody does. What it gives is valid until the application goes on.
class Witness {
 public:
  virtual ~Witness() = default;
  virtual std::span<const TruthChannel> truth_channels() const noexcept = 0;
  /// One value for each channel, as they are now.
  virtual std::span<const double> truth_of(int robot) const noexcept = 0;
  /// Time since the reset [s].
  virtual double time_s() const noexcept = 0;
  /// What tasks keep of each robot.
  virtual std::span<const LedgerForm> ledgers() const noexcept { return {}; }
  /// What one of them keeps; null where there is none of that id.
  virtual const Ledger* ledger(int robot, std::string_view task) const noexcept {
    static_cast<void>(robot), static_cast<void>(task);
    return nullptr;
  }
  virtual std::span<const PlacedMover> movers() const noexcept { return {}; }
};

}  // namespace ganglion
