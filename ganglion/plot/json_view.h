#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/plot/view/run_view.h"

namespace ganglion::plot {

// Readers of the JSON in run files. Whatever they are given they return something: what is missing or of another type
// takes the default, lists are cut at the limits below.

using Json = nlohmann::json;

inline constexpr std::size_t kMaxShapes = 20000;
inline constexpr std::size_t kMaxBlocks = 200000;
inline constexpr std::size_t kMaxPoints = 100000;  ///< Of one outline or route.
inline constexpr int kMaxMapSide = 16384;          ///< Cells of a scanned map, each way.

/// The object in `text`; none if it is anything else.
std::optional<Json> parse_object(std::string_view text);
double number_in(const Json& object, const char* key, double otherwise = 0);
std::string text_in(const Json& object, const char* key);
/// [[x, y], ...]
std::vector<Vector2> points_in(const Json& object, const char* key);
/// [x, y, yaw]
Pose2 pose_in(const Json& object, const char* key);

/// A ganglion.Scene, as ganglion/sim/world/scene.h describes it; movers without their later places.
Scene scene_from(const Json& scene);

/// What a coordinator decided, from its entry {"id", "candidates"} in ganglion.Run and the recorded signals; none where
/// these do not tell.
std::optional<Coordination> coordination_from(const Json& coordinator, const SignalTable& signals);

}  // namespace ganglion::plot
