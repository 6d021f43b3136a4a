#pragma once

#include <memory>
#include <span>

#include "ganglion/base/expects.h"
#include "ganglion/descriptor/parameters.h"
#include "ganglion/descriptor/ports.h"
#include "ganglion/exhibit/exhibit.h"
#include "ganglion/module/experience.h"
#include "ganglion/module/tick/feedback.h"
#include "ganglion/random/draws.h"

namespace ganglion {

/// What the graph gives a component once, after all are made: places in the block of values.
struct Links {
  std::span<const PortView> inputs{};            ///< One for each input of the descriptor, in its order.
  std::span<const std::span<double>> outputs{};  ///< One for each Output of the descriptor, in its order.
  std::span<double> appraisal{};                 ///< Of an acting module that sends one.
  StreamId stream{};                             ///< Its own source of chance.
};

/// What all kinds of all classes share: links, experience, something to show, growth between ticks.
class Component : public Learner, public Exhibitor {
 public:
  Component() = default;
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  virtual void bind(const Links& links) {
    links_ = links;
    bound();
  }
  /// Takes memory for what the next tick may need, up to the kind's stated cap. Called between ticks.
  virtual void grow() {}

 protected:
  /// Called once the links are there: memory that depends on what is wired is taken here.
  virtual void bound() {}
  /// The values of the n-th Output of the descriptor.
  std::span<double> output(std::size_t n) const noexcept { return links_.outputs[n]; }
  void put(std::size_t n, double value) const noexcept { links_.outputs[n][0] = value; }
  Draws draws(const Tick& tick) const noexcept { return Draws(links_.stream, tick.number); }
  const Links& links() const noexcept { return links_; }

 private:
  Links links_;
};

/// A kind: what it says of itself, and how one is made. Defined as a constant in the kind's own folder.
template <class Product>
struct Kind {
  Descriptor descriptor;
  /// Fails with BadParameter where values contradict each other; single ranges were held before. Takes little time and
  /// memory: every check of a file makes one on trial; what needs more is taken in bound() or grow().
  Result<std::unique_ptr<Product>> (*make)(const Parameters&) = nullptr;
  /// Ports as the parameters shape them, where they do. Known before wires are read; null = those of the descriptor.
  Result<Ports> (*shape)(const Parameters&) = nullptr;
  /// Of a kind that learns: what is stored of a part's raw bytes; null = the same.
  Encode encode = nullptr;
};

/// How most kinds are made: the Config with what the file gives, judged where the kind has something to judge, which may
/// also work out what hangs together: `static Result<void> judge(Config&)`, or with the Parameters as well.
template <class Product, class Made, class Config>
Result<std::unique_ptr<Product>> make_bound(const Parameters& values) {
  Config config = values.filled<Config>();
  Result<void> judged;
  if constexpr (requires { Made::judge(config, values); }) judged = Made::judge(config, values);
  if constexpr (requires { Made::judge(config); }) judged = Made::judge(config);
  if (!judged) return tl::unexpected<Error>(judged.error());
  return std::make_unique<Made>(std::move(config));
}

}  // namespace ganglion
