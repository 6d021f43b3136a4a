#include "ganglion/graph/testing/kinds.h"

#include <array>

#include "ganglion/graph/testing/first.h"
#include "ganglion/graph/testing/puppet.h"
#include "ganglion/graph/testing/ruled.h"
#include "ganglion/graph/testing/seeker.h"
#include "ganglion/graph/testing/sensing_kinds.h"
#include "ganglion/graph/testing/wish.h"

namespace ganglion::testing {

KindList kinds() noexcept {
  static constexpr std::array kSensing = {&gain_kind,   &copy_kind,  &surprise_kind, &sum_kind,
                                          &age_of_kind, &noise_kind, &ruled_kind};
  static constexpr std::array kGoal = {&wish_kind};
  static constexpr std::array kActing = {&seeker_kind, &turner_kind, &walker_kind, &puppet_kind};
  static constexpr std::array kCoordinator = {&first_kind};
  return {kSensing, kGoal, kActing, kCoordinator};
}

}  // namespace ganglion::testing
