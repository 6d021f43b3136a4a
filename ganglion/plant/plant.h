#pragma once

#include <limits>
#include <span>
#include <string_view>

#include "ganglion/application/description.h"
#include "ganglion/module/component.h"

namespace ganglion {

/// One value that is true of a plant, as its kind describes it.
struct PlantTruth {
  std::string_view name;
  std::string_view unit;
  Text title;
  bool digested = false;
};

/// Something to be controlled that is no robot: an oven, a pendulum, a tank. One object is one plant; it takes no memory
/// after reset(). Besides what its kind describes every plant has the sensation `trial`: which it is in, counted from 0.
class Plant {
 public:
  Plant() = default;
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;
  virtual ~Plant() = default;

  /// Limits and safe value of the n-th value of its Command ports.
  virtual CommandElement element(std::size_t n) const = 0;
  /// Between what the finite values of the n-th Output lie.
  struct Limits {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
  };
  virtual Limits limits(std::size_t output) const noexcept {
    static_cast<void>(output);
    return {};
  }
  /// The same whenever it is asked.
  virtual std::span<const PlantTruth> truths() const noexcept = 0;

  /// A trial begins: the first of an episode, or one more after it failed.
  virtual void reset() = 0;
  /// Commands hold for step_s; finite and within their limits. `draws` belong to this tick.
  virtual void step(std::span<const double> commands, double step_s, Draws& draws) noexcept = 0;
  /// The values of its Output ports, one after the other.
  virtual void sense(std::span<double> values) const noexcept = 0;
  virtual void tell(std::span<double> truths) const noexcept = 0;
  /// What the last step cost, in the kind's own unit.
  virtual double cost() const noexcept = 0;
  /// It cannot go on, and has to begin anew.
  virtual bool failed() const noexcept { return false; }
};

/// A kind's descriptor has Command ports and Output ports, its sensations. See ganglion/plant/<kind>/.
using PlantKind = Kind<Plant>;

}  // namespace ganglion
