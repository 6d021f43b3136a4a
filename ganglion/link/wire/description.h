#pragma once

#include <string>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/base/result.h"
#include "ganglion/link/wire/link.pb.h"

namespace ganglion::link {

/// Limits of what a robot may describe.
inline constexpr int kMaxRobots = 10'000;
inline constexpr int kMaxChannels = 1'000;
inline constexpr int kMaxElements = 4'096;  ///< Of one channel; a pixel matrix has 64.
inline constexpr std::size_t kMaxNameBytes = 100;

void write_description(const Description& description, wire::Describe& out);

/// Fails with TooLarge or BadParameter, in words, where a description is beyond the limits or makes no sense.
Result<Description> read_description(const wire::Describe& message);

/// One respect in which a robot is not what a controller was drawn for.
struct Difference {
  std::string channel;  ///< Of which sensation or command; "" = of the whole robot.
  Sentence text;        ///< "unit: the robot has \"cm\", the file \"m\""
  bool grave = false;   ///< The controller cannot drive it.
};
/// Compares by name: the order of channels and what the robot offers besides do not matter.
std::vector<Difference> differences(const Description& file, const Description& robot);
/// "sonar_left.range: unit: the robot has \"cm\", the file \"m\"".
Sentence text_of(const Difference& difference);

}  // namespace ganglion::link
