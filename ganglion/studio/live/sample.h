#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/record/exhibit/shown.h"

namespace ganglion::studio {

/// What a binary message to the page holds (docs/studio_api.md, Samples).
enum class SampleKind : std::uint8_t { Row = 1, Movers = 4, Bundle = 5, Field = 6, Exhibit = 7 };
std::string_view name_of(SampleKind kind) noexcept;

struct SampleHead {
  std::uint16_t stream = 0;
  std::uint32_t seq = 0;
  double time_s = 0;
};

/// A field as it is now, and when each cell changed last: what changed since any earlier state can be told without
/// keeping that state.
class FieldState {
 public:
  /// Takes a whole state, or a patch to the one before. False, and nothing changed, where it is none or does not fit.
  bool take(const shown::Exhibit& state, std::uint32_t seq);
  std::uint32_t seq() const noexcept { return seq_; }
  /// What changed after `base`; all that is known, with words and scales, where base is 0 or of another make of the
  /// field.
  std::string sample(const SampleHead& head, std::uint32_t base) const;

 private:
  void take_whole(const shown::Field& field, std::uint32_t seq);

  std::uint32_t seq_ = 0;
  std::uint32_t remade_ = 0;  ///< Since when it has this make.
  Sentence title_;
  shown::Field field_;
  std::vector<std::uint32_t> changed_;
};

std::string row_sample(const SampleHead& head, std::uint32_t tick, std::span<const double> values);
std::string movers_sample(const SampleHead& head, std::string_view json);
/// Of anything that is shown but a field, as JSON.
std::string exhibit_sample(const SampleHead& head, const shown::Exhibit& exhibit);
/// Several samples in one message, each begun at a multiple of eight bytes, so that its numbers can be used in place.
std::string bundle_sample(std::span<const std::shared_ptr<const std::string>> samples);

}  // namespace ganglion::studio
