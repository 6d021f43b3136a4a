#include "ganglion/descriptor/descriptor.h"

#include <array>

namespace ganglion {
namespace {

constexpr std::array kStandingOutputs = {
    PortDescriptor{.name = "active",
                   .title = {"active", "activo"},
                   .help = {"1 while the module commands, 0 while it is inactive, waits or has withdrawn",
                            "1 mientras el módulo manda; 0 si está inactivo, espera o se ha retirado"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
    PortDescriptor{.name = "status",
                   .title = {"status", "estado"},
                   .help = {"State of the request: 0 none, 1 pending, 2 satisfied, 3 withdrawn",
                            "Estado de la solicitud: 0 ninguna, 1 pendiente, 2 satisfecha, 3 retirada"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
    PortDescriptor{.name = "reason",
                   .title = {"reason", "motivo"},
                   .help = {"Why the last request was withdrawn: 0 not withdrawn, else a reason code",
                            "Motivo de la última retirada: 0 sin retirada; si no, un código"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
    PortDescriptor{
        .name = "settled",
        .title = {"settled", "mantenida"},
        .help = {"1 while the set-point asked for counts as held", "1 mientras la consigna pedida se mantiene"},
        .role = PortRole::Output,
        .type = ValueType::Discrete,
        .derived = true},
};
constexpr std::span kActingOutputs = std::span<const PortDescriptor>(kStandingOutputs).first(3);

constexpr std::array kCoordinatorOutputs = {
    PortDescriptor{.name = "active",
                   .title = {"driving", "conduce"},
                   .help = {"Index of the candidate that drives, or has the largest part; -1 = none",
                            "Índice del candidato que conduce, o tiene la parte mayor; -1 = ninguno"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
    PortDescriptor{.name = "share",
                   .title = {"share", "parte"},
                   .help = {"Part of each candidate in the result", "Parte de cada candidato en el resultado"},
                   .role = PortRole::Output,
                   .many = true,
                   .meaning = Meaning::Share},
    PortDescriptor{.name = "wanted",
                   .title = {"wanted", "querido"},
                   .help = {"1 while a candidate wants to drive", "1 mientras un candidato quiere conducir"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .many = true},
    PortDescriptor{.name = "suppressed",
                   .title = {"suppressed", "suprimido"},
                   .help = {"1 while a candidate wants to drive and has no part",
                            "1 mientras un candidato quiere conducir y no tiene parte"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .many = true},
};

constexpr std::array kGoalOutputs = {
    PortDescriptor{.name = "intensity",
                   .title = {"intensity", "intensidad"},
                   .help = {"How strongly it wants what it asks for; 0 = it wants nothing",
                            "Con cuánta fuerza quiere lo que pide; 0 = no quiere nada"},
                   .role = PortRole::Output,
                   .derived = true},
    PortDescriptor{.name = "holds",
                   .title = {"holds", "en curso"},
                   .help = {"1 while a request of it is under way", "1 mientras una solicitud suya está en curso"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .derived = true},
    PortDescriptor{
        .name = "rests_s",
        .title = {"rests", "calla"},
        .help = {"How long it keeps still yet after a Withdrawal", "Cuánto calla todavía después de una retirada"},
        .role = PortRole::Output,
        .unit = "s",
        .derived = true},
};

template <class Item>
const Item* find(std::span<const Item> items, std::string_view name) noexcept {
  for (const Item& item : items) {
    if (item.name == name) return &item;
  }
  return nullptr;
}

}  // namespace

std::string_view name_of(ComponentClass component_class) noexcept {
  constexpr std::array<std::string_view, 11> kNames = {"sensation",   "sensing", "goal",   "acting",
                                                       "coordinator", "sensor",  "drive",  "plant",
                                                       "task",        "measure", "picture"};
  return kNames[static_cast<std::size_t>(component_class)];
}

std::string_view name_of(ValueType type) noexcept {
  constexpr std::array<std::string_view, 3> kNames = {"real", "discrete", "circular"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string_view name_of(PortRole role) noexcept {
  constexpr std::array<std::string_view, 6> kNames = {"request",   "feedback", "candidate",
                                                      "appraisal", "command",  "output"};
  return kNames[static_cast<std::size_t>(role)];
}

std::string_view name_of(ParameterType type) noexcept {
  constexpr std::array<std::string_view, 7> kNames = {"real", "integer", "boolean", "choice", "word", "reals", "file"};
  return kNames[static_cast<std::size_t>(type)];
}

bool is_input(ComponentClass component_class, PortRole role) noexcept {
  switch (role) {
    case PortRole::Request:
    case PortRole::Feedback:
    case PortRole::Candidate:
      return true;
    case PortRole::Appraisal:
      return component_class == ComponentClass::Sensing;
    case PortRole::Command:
    case PortRole::Output:
      return false;
  }
  return false;
}

std::vector<std::string> element_names(const PortDescriptor& port) {
  std::vector<std::string> names;
  for (const ElementDescriptor& element : port.elements) names.emplace_back(element.name);
  return names;
}

const PortDescriptor* Descriptor::port(std::string_view port_name) const noexcept { return find(ports, port_name); }

const ParameterDescriptor* Descriptor::parameter(std::string_view parameter_name) const noexcept {
  return find(parameters, parameter_name);
}

std::span<const PortDescriptor> common_outputs(ComponentClass component_class,
                                               std::span<const PortDescriptor> ports) noexcept {
  if (component_class == ComponentClass::Coordinator) return kCoordinatorOutputs;
  if (component_class == ComponentClass::Goal) return kGoalOutputs;
  if (component_class != ComponentClass::Acting) return {};
  for (const PortDescriptor& port : ports) {
    if (port.role == PortRole::Request && port.standing) return kStandingOutputs;
  }
  return kActingOutputs;
}

}  // namespace ganglion
