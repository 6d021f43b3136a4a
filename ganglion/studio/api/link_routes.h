#pragma once

#include <cstdint>
#include <memory>

#include "ganglion/studio/api/hooks.h"
#include "ganglion/studio/api/link_check.h"
#include "ganglion/studio/api/router.h"
#include "ganglion/studio/api/wanted.h"

namespace ganglion::studio {

/// The commands that try whether a robot is there and what it offers, one test at a time.
class LinkRoutes {
 public:
  /// Folder, reader and this object must outlive the router's last call.
  LinkRoutes(Router& router, const Folder& folder, const WantedReader& wanted, OnHub on_hub);

 private:
  Reply test(const Ask&);
  Reply test_simulation(const Wanted& wanted, const Ask&);
  Result<LinkCheck::Subject> subject_of(const Experiment& experiment, const Ask&) const;

  const Folder& folder_;
  const WantedReader& wanted_;
  const OnHub on_hub_;
  std::unique_ptr<LinkCheck> test_;
  Json tested_;  ///< What the last test of the simulation found.
  std::uint64_t tests_ = 0;
};

}  // namespace ganglion::studio
