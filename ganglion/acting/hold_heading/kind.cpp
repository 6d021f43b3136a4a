#include <array>

#include "ganglion/acting/hold_heading/hold_heading.h"

namespace ganglion {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "heading",
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"Yaw by compass", "Rumbo de la brújula"}},
    PortDescriptor{.name = "displaced_by",
                   .type = ValueType::Discrete,
                   .required = false,
                   .many = true,
                   .help = {"Whether a behaviour above drove in the tick before: \"escape.active@previous\"",
                            "Si un comportamiento superior condujo en el ciclo anterior: \"escape.active@previous\""}},
    subsumption::sonar_port(true, false),
    subsumption::sonar_port(false, false),
    PortDescriptor{
        .name = "course",
        .unit = "rad",
        .type = ValueType::Circular,
        .required = false,
        .help = {"Course to steer instead of the heading at the start", "Rumbo que seguir en lugar del inicial"}},
    subsumption::kTracksPort,
    PortDescriptor{.name = "original",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"The course it returns to", "El rumbo al que vuelve"}},
    PortDescriptor{
        .name = "target",
        .role = PortRole::Output,
        .unit = "rad",
        .type = ValueType::Circular,
        .help = {"What it steers now: the course or a held one", "Lo que sigue ahora: el rumbo o el mantenido"}},
    PortDescriptor{.name = "error",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .help = {"Target less heading, counter-clockwise; listing: not wrapped",
                            "Objetivo menos rumbo, antihorario; listing: sin reducir"}},
    PortDescriptor{.name = "held",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"1 while a held course is steered", "1 mientras sigue un rumbo mantenido"}},
    PortDescriptor{.name = "blind",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"1 while it goes without a heading, or stops for want of sonars",
                            "1 mientras va sin brújula o se detiene por falta de sonares"}},
};

constexpr std::array kParameters = {
    subsumption::kPresetParameter,
    ParameterDescriptor{.name = "gain_per_deg",
                        .unit = "1/deg",
                        .preset = 0.0025,
                        .min = 0,
                        .max = 1,
                        .help = {"Duty of the turn for each degree of error (3 of 1200 counts)",
                                 "Ciclo de trabajo del giro por grado de error (3 de 1200 cuentas)"}},
    ParameterDescriptor{.name = "forward_duty",
                        .preset = 1.0 / 3,
                        .min = 0,
                        .max = 1,
                        .help = {"Duty ahead while on course", "Ciclo de trabajo hacia delante si va en rumbo"}},
    ParameterDescriptor{.name = "fade_deg",
                        .unit = "deg",
                        .preset = 90,
                        .min = 1,
                        .max = 360,
                        .help = {"Error at which it turns on the spot", "Error con que gira en el sitio"},
                        .ours = true},
    ParameterDescriptor{.name = "hold_s",
                        .unit = "s",
                        .preset = 3.0,
                        .min = 0,
                        .max = 600,
                        .help = {"Holds the heading it was left with for so long; listing: 15 cycles",
                                 "Mantiene este tiempo el rumbo en que quedó; listing: 15 ciclos"},
                        .ours = true},
    ParameterDescriptor{.name = "settle_s",
                        .unit = "s",
                        .preset = 1.5,
                        .min = 0,
                        .max = 60,
                        .help = {"For so long the held course follows the heading: the lag of the compass",
                                 "Durante este tiempo el rumbo mantenido sigue a la brújula: su retraso"},
                        .ours = true},
    ParameterDescriptor{.name = "hold_growth",
                        .preset = 2.0,
                        .min = 0,
                        .max = 100,
                        .help = {"Holds so many seconds for each one of being displaced, if that is more than hold_s",
                                 "Mantiene tantos segundos por cada uno de desplazamiento, si supera hold_s"},
                        .ours = true},
    ParameterDescriptor{.name = "max_hold_s",
                        .unit = "s",
                        .preset = 48,
                        .min = 0,
                        .max = 3600,
                        .help = {"Longest time of holding", "Tiempo máximo de mantener"},
                        .ours = true},
    ParameterDescriptor{.name = "hold_return",
                        .preset = 0,
                        .min = 0,
                        .max = 1,
                        .help = {"Share of the way back to the course that a held course goes after its first hold_s",
                                 "Parte del regreso al rumbo que hace uno mantenido tras sus primeros hold_s"},
                        .ours = true},
    ParameterDescriptor{.name = "calm_s",
                        .unit = "s",
                        .preset = 5.0,
                        .min = 0,
                        .max = 3600,
                        .help = {"After so long on course the time of being displaced is forgotten",
                                 "Tras este tiempo en rumbo se olvida el tiempo de desplazamiento"},
                        .ours = true},
    ParameterDescriptor{.name = "agreement_deg",
                        .unit = "deg",
                        .preset = 5,
                        .min = 0,
                        .max = 180,
                        .help = {"Three readings this near to each other give the course",
                                 "Tres lecturas así de próximas dan el rumbo"},
                        .ours = true},
    ParameterDescriptor{.name = "patience_s",
                        .unit = "s",
                        .preset = 0.5,
                        .min = 0,
                        .max = 60,
                        .help = {"Keeps the last command for so long without a heading",
                                 "Mantiene el último mando este tiempo sin brújula"},
                        .ours = true},
    ParameterDescriptor{.name = "blind_share",
                        .preset = 0.5,
                        .min = 0,
                        .max = 1,
                        .help = {"Share of the speed ahead, straight on, once the heading is lost; 0 = it stops",
                                 "Parte de la velocidad, todo recto, cuando falta la brújula; 0 = se detiene"},
                        .ours = true},
    ParameterDescriptor{.name = "slow_range_m",
                        .unit = "m",
                        .preset = 0.60,
                        .min = 0.01,
                        .max = 10,
                        .help = {"Below this range it goes slower, in proportion",
                                 "Por debajo de esta distancia va más lento, en proporción"},
                        .ours = true},
    ParameterDescriptor{.name = "least_share",
                        .preset = 0.3,
                        .min = 0,
                        .max = 1,
                        .help = {"Share of the speed ahead that is left however near", "Parte mínima de la velocidad"},
                        .ours = true},
    subsumption::kOneSonarShareParameter,
};

}  // namespace

Result<HoldHeadingConfig> HoldHeadingConfig::from(const Parameters& parameters) {
  if (auto fixed = subsumption::check_listing(parameters); !fixed) return tl::unexpected(fixed.error());
  HoldHeadingConfig config;
  config.preset = subsumption::preset_of(parameters);
  config.gain_per_deg = parameters.real("gain_per_deg");
  config.forward_duty = parameters.real("forward_duty");
  config.fade_deg = parameters.real("fade_deg");
  config.hold_s = parameters.real("hold_s");
  config.settle_s = parameters.real("settle_s");
  config.hold_growth = parameters.real("hold_growth");
  config.max_hold_s = parameters.real("max_hold_s");
  config.hold_return = parameters.real("hold_return");
  config.calm_s = parameters.real("calm_s");
  config.agreement_deg = parameters.real("agreement_deg");
  config.patience_s = parameters.real("patience_s");
  config.blind_share = parameters.real("blind_share");
  config.slow_range_m = parameters.real("slow_range_m");
  config.least_share = parameters.real("least_share");
  config.one_sonar_share = parameters.real("one_sonar_share");
  return config;
}

Result<std::unique_ptr<ActingModule>> HoldHeading::make(const Parameters& parameters) {
  const auto config = HoldHeadingConfig::from(parameters);
  if (!config) return tl::unexpected(config.error());
  return std::make_unique<HoldHeading>(*config);
}

extern constinit const ActingModuleKind hold_heading_kind{
    .descriptor = {.component_class = ComponentClass::Acting,
                   .name = "HoldHeading",
                   .summary = {"Drives along a course by compass", "Avanza por un rumbo según la brújula"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Alonso, robot Nimrod, sections 3 and 5 (NAVEGAR)"},
    .make = HoldHeading::make};

}  // namespace ganglion
