#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "ganglion/record/exhibit/track.h"
#include "ganglion/record/run_file.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

/// A recorded run told as a live one is: the same streams, events and samples.
class RecordingView {
 public:
  explicit RecordingView(RunFile file);

  /// docs/studio_api.md, /api/recording/open; without "run"; damages in that language.
  Json head(Language language) const;
  /// Samples with from_s <= t <= to_s in order of time, each behind its length as u32; of rows every nth. Fields
  /// begin with their whole state at from_s.
  std::string samples(double from_s, double to_s, std::size_t every) const;
  /// The controller it was made with; "" where the file does not hold it.
  std::string controller() const;

 private:
  double duration_s() const;
  std::uint16_t stream_of(std::size_t exhibit) const noexcept {
    return static_cast<std::uint16_t>(file_.tables.size() + 2 + exhibit);
  }

  RunFile file_;
  const JsonTopic* movers_ = nullptr;
  std::vector<ExhibitTrack> exhibits_;
};

}  // namespace ganglion::studio
