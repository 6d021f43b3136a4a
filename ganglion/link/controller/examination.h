#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ganglion/application/description.h"
#include "ganglion/link/controller/line.h"

namespace ganglion::link {

struct ExaminationOptions {
  double reach_s = 0;                 ///< Goes on trying to connect for so long; 0 = one attempt.
  double patience_s = 5;              ///< With each step: connecting, greeting, waiting for heartbeats.
  const Description* file = nullptr;  ///< The robot a controller was drawn for: what differs is told.
  int robots = 0;                     ///< How many there should be; 0 = any number.
  std::function<bool()> stop;         ///< Asked again and again; true ends it early.
};

/// Looks at a robot without moving it: watches, measures, and says in plain words what it offers and what is wrong.
/// `say` gets whether a finding is good, and the finding. Returns whether all were.
bool examine(std::unique_ptr<Line> line, const std::function<void(bool good, const Sentence& finding)>& say,
             const ExaminationOptions& options = {});

}  // namespace ganglion::link
