#pragma once

#include <string>
#include <variant>

#include "ganglion/geometry/vector2.h"

namespace ganglion::sim {

/// A robot is to go to a point: its trainer makes the cell that holds the point the goal.
struct SetGoal {
  int robot = 0;
  Vector2 point;
};

/// A mover is to stand with its centre at a point.
struct PutMover {
  std::string mover;  ///< Its id.
  Vector2 point;
};

/// Something that a person does to a simulated world while it runs, between ticks. Ours, after the ruling that the
/// application (trainer) may replace its own request.
using Intervention = std::variant<SetGoal, PutMover>;

/// What came of one.
struct Intervened {
  Vector2 point;          ///< That of the intervention; of a goal the centre of its cell.
  bool reachable = true;  ///< Of a goal: see GoalRecord.
};

}  // namespace ganglion::sim
