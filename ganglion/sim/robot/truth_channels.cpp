#include "ganglion/sim/robot/truth_channels.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ganglion::sim {
namespace {

struct Channel {
  std::string_view name, unit;
  Text title;
  bool digested;
};

/// In the order of write_truth().
constexpr std::array kChannels = {
    Channel{"x_m", "m", {"position east", "posición al este"}, true},
    Channel{"y_m", "m", {"position north", "posición al norte"}, true},
    Channel{"yaw_rad", "rad", {"yaw", "rumbo"}, true},
    Channel{"touching", "", {"touching at any moment of the step", "tocando en algún momento del paso"}, false},
    Channel{"energy_J", "J", {"energy taken", "energía consumida"}, true},
    Channel{"travelled_m", "m", {"way of the centre", "camino del centro"}, false},
    Channel{"contacts", "", {"contacts begun", "contactos empezados"}, false},
    Channel{"fastest_contact_mps", "m/s", {"speed of the hardest contact", "velocidad del contacto más fuerte"}, false},
    Channel{"stalled", "", {"kept from climbing", "sin poder subir"}, false},
    Channel{"tipped", "", {"fallen over", "volcado"}, false},
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
  const std::array<double, kChannels.size()> values = {truth.pose.position.x,
                                                       truth.pose.position.y,
                                                       truth.pose.yaw.rad(),
                                                       truth.touched ? 1.0 : 0.0,
                                                       truth.energy_J,
                                                       truth.travelled_m,
                                                       static_cast<double>(truth.contacts),
                                                       truth.fastest_contact_mps,
                                                       truth.stalled ? 1.0 : 0.0,
                                                       truth.tipped ? 1.0 : 0.0};
  std::ranges::copy(values, row.begin());
}

}  // namespace ganglion::sim
