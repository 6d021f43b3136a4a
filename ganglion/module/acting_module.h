#pragma once

#include "ganglion/module/component.h"
#include "ganglion/module/tick/acting_cycle.h"

namespace ganglion {

/// A functionality acquired while acting (orange in the GFM papers): the cycle, and what a host wants of a component.
class ActingModule : public Component, public ActingCycle {
 public:
  void bind(const Links& links) override {
    see(links.inputs, links.appraisal);
    Component::bind(links);
  }
  /// The sequence of commands planned, the first of which was sent; for onlookers.
  virtual std::span<const Command> plan() const noexcept { return {}; }
};

using ActingModuleKind = Kind<ActingModule>;

}  // namespace ganglion
