#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/base/files.h"
#include "ganglion/config/table.h"

namespace ganglion {

/// An application as its files state it: immutable, shared by any number of runs and threads. What it is; where it runs
/// is another question.
class ApplicationModel {
 public:
  virtual ~ApplicationModel() = default;
  /// With the channels of its tasks.
  virtual const Description& description() const noexcept = 0;
  /// What is true of each robot where it runs in this program; empty where nobody knows.
  virtual std::span<const TruthChannel> truth() const noexcept { return {}; }
  /// What its tasks keep.
  virtual std::span<const LedgerForm> ledgers() const noexcept { return {}; }
  /// Ids of its tasks: channels "id.quantity" are theirs, no device's.
  virtual std::span<const std::string> tasks() const noexcept { return {}; }
  /// The ground, with nothing that moves; null where there is none.
  virtual const Terrain* terrain() const noexcept { return nullptr; }
  /// Whether ticks of that length can be carried out. Fails with TooLarge, and the place of what asks for too much.
  virtual Result<void> fits(double step_s) const {
    static_cast<void>(step_s);
    return {};
  }
  /// To run in this program. Fails with Unsupported where it is only described, with BadParameter where its parts cannot
  /// be put together.
  virtual Result<std::unique_ptr<Application>> make() const = 0;
  /// The same where nothing stands in its way, to begin as the other one stands: the yardstick of progress. Null where
  /// there is none.
  virtual Result<std::unique_ptr<Application>> unhindered(const Application& other) const {
    static_cast<void>(other);
    return std::unique_ptr<Application>();
  }
  /// What stands round it as that episode begins, as JSON of the schema ganglion.Scene; "" where there is nothing.
  virtual std::string scene(std::uint64_t seed, std::uint32_t episode) const {
    static_cast<void>(seed), static_cast<void>(episode);
    return {};
  }
};

/// What an application is read from.
struct ApplicationSource {
  const config::Value& file;         ///< Of the file that says what it is: robot.toml, process.toml.
  FileReader* files = nullptr;       ///< Opens what is named; null: nothing is opened.
  config::Table* setting = nullptr;  ///< [application] of an experiment; null: only what it is is wanted.
  int world = -1;                    ///< Of `files`: what the setting names as its surroundings; -1 = nothing.
  std::span<const config::Override> world_overrides{};
  int robots = 1;
  bool here = true;                    ///< It is to run in this program.
  config::Outline* outline = nullptr;  ///< Takes down what was asked of the file.
};

}  // namespace ganglion
