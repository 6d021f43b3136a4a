#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "ganglion/exhibit/exhibit.h"
#include "ganglion/record/exhibit/track.h"
#include "ganglion/record/run_sink.h"

namespace ganglion {

/// Writes what is shown during one run, by whomever, when it differs from what was shown last: fields whole once and
/// then the rectangle that changed (whole each time to those who only watch), all else whole. Fields in the world go
/// into an archive as foxglove.Grid as well, for other people's viewers: one byte a layer and cell on
/// "/robot0/map/router/map".
class ExhibitRecorder {
 public:
  explicit ExhibitRecorder(RunSink& sink) : sink_(sink) {}

  /// Between ticks; never alters what it looks at.
  void show(const Exhibitor& exhibitor, const ExhibitOwner& owner, double time_s);

 private:
  class Look;
  struct Known {
    std::uint64_t generation = 0;
    shown::Field field;  ///< Of a field, as it was told.
    std::string bytes;   ///< Of anything else.
  };

  RunSink& sink_;
  std::map<std::string, Known, std::less<>> known_;  ///< By topic.
};

}  // namespace ganglion
