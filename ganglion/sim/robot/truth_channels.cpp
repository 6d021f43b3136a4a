#include "ganglion/sim/robot/truth_channels.h"

#include <array>
#include <vector>

namespace ganglion::sim {
namespace {

struct Channel {
  std::string_view name, unit;
  Text title;
  bool digested;
  double (*value)(const Truth&);
};

constexpr std::array kChannels = {
    Channel{"x_m", "m", {"position east", "posición al este"}, true, [](const Truth& t) { return t.pose.position.x; }},
    Channel{
        "y_m", "m", {"position north", "posición al norte"}, true, [](const Truth& t) { return t.pose.position.y; }},
    Channel{"yaw_rad", "rad", {"yaw", "rumbo"}, true, [](const Truth& t) { return t.pose.yaw.rad(); }},
    Channel{"touching",
            "",
            {"touching at any moment of the step", "tocando en algún momento del paso"},
            false,
            [](const Truth& t) { return t.touched ? 1.0 : 0.0; }},
    Channel{"energy_J", "J", {"energy taken", "energía consumida"}, true, [](const Truth& t) { return t.energy_J; }},
    Channel{"travelled_m",
            "m",
            {"way of the centre", "camino del centro"},
            false,
            [](const Truth& t) { return t.travelled_m; }},
    Channel{"contacts",
            "",
            {"contacts begun", "contactos empezados"},
            false,
            [](const Truth& t) { return static_cast<double>(t.contacts); }},
    Channel{"fastest_contact_mps",
            "m/s",
            {"speed of the hardest contact", "velocidad del contacto más fuerte"},
            false,
            [](const Truth& t) { return t.fastest_contact_mps; }},
    Channel{"stalled",
            "",
            {"kept from climbing", "sin poder subir"},
            false,
            [](const Truth& t) { return t.stalled ? 1.0 : 0.0; }},
    Channel{"tipped", "", {"fallen over", "volcado"}, false, [](const Truth& t) { return t.tipped ? 1.0 : 0.0; }},
};

}  // namespace

std::span<const TruthChannel> truth_channels() noexcept {
  static const std::vector<TruthChannel> kList = [] {
    std::vector<TruthChannel> list;
    for (const Channel& one : kChannels) {
      list.push_back({std::string(one.name), std::string(one.unit), say({"{}", "{}"}, one.title), one.digested});
    }
    return list;
  }();
  return kList;
}

void write_truth(const Truth& truth, std::span<double> row) noexcept {
  for (std::size_t i = 0; i < kChannels.size(); ++i) row[i] = kChannels[i].value(truth);
}

}  // namespace ganglion::sim
