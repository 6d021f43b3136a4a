#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/geometry/vector2.h"

namespace ganglion::studio {

/// What a binary message to the page holds (docs/studio_api.md, Samples).
enum class SampleKind : std::uint8_t { Row = 1, Grid = 2, Path = 3, Movers = 4, Bundle = 5 };
std::string_view name_of(SampleKind kind) noexcept;

struct SampleHead {
  std::uint16_t stream = 0;
  std::uint32_t seq = 0;
  double time_s = 0;
};

/// A map as it is now, and when each cell changed last: what changed since any earlier state can be told without
/// keeping that state.
class GridState {
 public:
  /// Takes a foxglove.Grid message as run files hold it. False, and nothing changed, where it is none.
  bool take(std::string_view json, std::uint32_t seq);
  std::uint32_t seq() const noexcept { return seq_; }
  const std::vector<std::string>& layers() const noexcept { return layers_; }
  /// What changed after `base`; all that is not 0 where base is 0 or of another shape of the map.
  std::string sample(const SampleHead& head, std::uint32_t base) const;

 private:
  std::uint32_t seq_ = 0;
  std::uint32_t reshaped_ = 0;  ///< Since when it has this shape.
  std::uint32_t columns_ = 0, rows_ = 0;
  Vector2 origin_{};
  double cell_m_ = 0;
  std::vector<std::string> layers_;
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint32_t> changed_;
};

std::string row_sample(const SampleHead& head, std::uint32_t tick, std::span<const double> values);
/// Of a ganglion.Path message; none where it is none.
std::optional<std::string> path_sample(const SampleHead& head, std::string_view json);
std::string movers_sample(const SampleHead& head, std::string_view json);
/// Several samples in one message, each begun at a multiple of eight bytes, so that its numbers can be used in place.
std::string bundle_sample(std::span<const std::shared_ptr<const std::string>> samples);

}  // namespace ganglion::studio
