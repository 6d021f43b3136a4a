#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct AudioEventsConfig {
  double missed = 0;    ///< Probability that an event is not heard.
  double mistaken = 0;  ///< Probability that one that is heard is taken for another.
  int alphabet = 8;     ///< Events are told apart up to this number; a mistaken one is any other of 1..alphabet.
};

/// Hears the words that beacons chirp, event by event. Channel `event`: the event that began since the sensor fired
/// last, 0 for silence; of several the loudest, of equally loud ones the one first in the file. Channel `loudness`: 1
/// at the beacon, falling in a straight line to 0 at the end of its hearing range; 0 in silence. Walls do not muffle.
/// Each event is reported once; where several of a word begin between two firings, only the last is heard. Ours.
class AudioEvents final : public Sensor {
 public:
  explicit AudioEvents(const AudioEventsConfig& config) noexcept : config_(config) {}
  Limits limits(std::size_t channel) const noexcept override { return {0, channel == 0 ? 255.0 : 1.0}; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  AudioEventsConfig config_;
  double fired_s_ = -1;  // nothing begins before 0
};

extern const SensorKind audio_events_kind;

}  // namespace ganglion::sim
