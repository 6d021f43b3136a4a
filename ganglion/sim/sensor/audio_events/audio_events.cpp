#include "ganglion/sim/sensor/audio_events/audio_events.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr double kTolerance_s = 1e-9;  // times of steps are products and differ from sums by rounding

constexpr std::array kPorts = {
    PortDescriptor{.name = "event",
                   .title = {"event", "evento"},
                   .help = {"The event that began since the last firing; 0 = silence",
                            "El evento que empezó desde el último disparo; 0 = silencio"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
    PortDescriptor{.name = "loudness",
                   .title = {"loudness", "sonoridad"},
                   .help = {"1 at the beacon, 0 at the end of its range and in silence",
                            "1 en la baliza, 0 al final de su alcance y en silencio"},
                   .role = PortRole::Output},
};

constexpr std::array kParameters = {
    parameter<AudioEventsConfig, &AudioEventsConfig::missed>(
        {.name = "missed",
         .title = {"miss probability", "probabilidad de pérdida"},
         .help = {"Probability that an event is not heard", "Probabilidad de no oír un evento"},
         .min = 0,
         .max = 1,
         .ours = true,
         .live = true}),
    parameter<AudioEventsConfig, &AudioEventsConfig::mistaken>(
        {.name = "mistaken",
         .title = {"confusion probability", "probabilidad de confusión"},
         .help = {"Probability that one that is heard is taken for another",
                  "Probabilidad de confundir con otro un evento oído"},
         .min = 0,
         .max = 1,
         .ours = true,
         .live = true}),
    parameter<AudioEventsConfig, &AudioEventsConfig::alphabet>(
        {.name = "alphabet",
         .title = {"alphabet size", "tamaño del alfabeto"},
         .help = {"A mistaken event is any other of 1 to that",
                  "Un evento confundido es cualquier otro de 1 hasta ese número"},
         .min = 2,
         .max = 255,
         .ours = true}),
};

struct Heard {
  int event = 0;
  double loudness = 0;
};

Heard loudest(const Scene& scene, double since_s) noexcept {
  Heard heard;
  for (const Beacon& beacon : scene.world.ground().plan().beacons) {
    const Beacon::Chirp chirp = beacon.last_chirp(scene.time_s);
    if (chirp.event == 0 || chirp.began_s <= since_s + kTolerance_s) continue;
    const double loudness = 1 - (beacon.position - scene.mount().position).length() / beacon.sound_range_m;
    if (loudness > heard.loudness) heard = {chirp.event, loudness};
  }
  return heard;
}

}  // namespace

Result<void> AudioEvents::reset(const Scene&, Draws) {
  fired_s_ = -1;
  return {};
}

void AudioEvents::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  Heard heard = loudest(scene, fired_s_);
  fired_s_ = scene.time_s;
  const bool missed = draws.uniform() < config_.missed;
  const bool mistaken = draws.uniform() < config_.mistaken;
  const auto alphabet = static_cast<std::uint32_t>(config_.alphabet);
  if (missed) heard = {};
  if (heard.event > 0 && mistaken) {
    const bool among = heard.event <= config_.alphabet;
    const auto other = 1 + static_cast<int>(draws.below(among ? alphabet - 1 : alphabet));
    heard.event = among && other >= heard.event ? other + 1 : other;
  }
  values[0] = heard.event;
  values[1] = heard.loudness;
}

extern constinit const SensorKind audio_events_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "AudioEvents",
                   .summary = {"Hears the words that beacons chirp", "Oye las palabras que emiten las balizas"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "the discrete audio events of the GFM papers' feedback; hearing ours"},
    .make = make_bound<Sensor, AudioEvents, AudioEventsConfig>};

}  // namespace ganglion::sim
