#include "ganglion/sim/sensor/sonar/sonar.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "range",
                   .role = PortRole::Output,
                   .unit = "m",
                   .help = {"Range of the echo; inf = none, -inf = too close, nan = dead",
                            "Distancia del eco; inf = ninguno, -inf = demasiado cerca, nan = averiado"}},
    PortDescriptor{.name = "echo_time",
                   .role = PortRole::Output,
                   .unit = "s",
                   .help = {"Time of the echo there and back, as the device measures it; 0 = no pulse",
                            "Tiempo de ida y vuelta del eco, como lo mide el sensor; 0 = sin pulso"}},
};

constexpr std::array<std::string_view, 3> kDevices = {"PING", "SRF02", "Polaroid"};
constexpr std::array<std::string_view, 2> kTooClose = {"minus_infinity", "minimum"};

constexpr std::array kParameters = {
    ParameterDescriptor{.name = "device",
                        .type = ParameterType::Choice,
                        .choices = kDevices,
                        .help = {"Sets the defaults of cone, range, resolution, echo times and blind zone",
                                 "Fija los valores de haz, alcance, resolución, tiempos de eco y zona ciega"}},
    ParameterDescriptor{.name = "cone_deg",
                        .unit = "deg",
                        .preset = 40,
                        .min = 0,
                        .max = 180,
                        .help = {"Full opening angle (-6 dB): PING 40, SRF02 50, Polaroid 30",
                                 "Ángulo total del haz (-6 dB): PING 40, SRF02 50, Polaroid 30"}},
    ParameterDescriptor{.name = "fading",
                        .type = ParameterType::Boolean,
                        .help = {"Whether echoes from the rim of the cone are weaker and so heard only from nearer",
                                 "Si los ecos del borde del haz son más débiles y solo se oyen desde más cerca"},
                        .ours = true},
    ParameterDescriptor{.name = "rays",
                        .type = ParameterType::Integer,
                        .preset = 7,
                        .min = 1,
                        .max = 63,
                        .help = {"Rays spread over the cone", "Rayos repartidos en el haz"},
                        .ours = true},
    ParameterDescriptor{.name = "min_range_m",
                        .unit = "m",
                        .preset = 0.02,
                        .min = 0,
                        .max = 100,
                        .help = {"End of the blind zone: PING 0.02, SRF02 0.16, Polaroid 0.41",
                                 "Fin de la zona ciega: PING 0.02, SRF02 0.16, Polaroid 0.41"}},
    ParameterDescriptor{.name = "max_range_m",
                        .unit = "m",
                        .preset = 3,
                        .min = 1e-3,
                        .max = 100,
                        .help = {"Reach: PING 3, SRF02 6, Polaroid 10.7", "Alcance: PING 3, SRF02 6, Polaroid 10.7"}},
    ParameterDescriptor{.name = "noise_m",
                        .unit = "m",
                        .preset = 0.01,
                        .min = 0,
                        .max = 10,
                        .help = {"Standard deviation of one reading", "Desviación típica de una lectura"}},
    ParameterDescriptor{
        .name = "resolution_m",
        .unit = "m",
        .preset = 0.001,
        .min = 0,
        .max = 10,
        .help = {"Ranges are multiples of it; 0 = not rounded", "Las distancias son múltiplos; 0 = sin redondeo"}},
    ParameterDescriptor{.name = "dropout",
                        .preset = 0,
                        .min = 0,
                        .max = 1,
                        .help = {"Probability that an echo is lost", "Probabilidad de perder un eco"},
                        .ours = true},
    ParameterDescriptor{.name = "rough_limit_deg",
                        .unit = "deg",
                        .preset = 90,
                        .min = 0,
                        .max = 90,
                        .help = {"Largest incidence at which a rough surface answers; 90 = always",
                                 "Mayor incidencia con que responde una superficie rugosa; 90 = siempre"},
                        .ours = true},
    ParameterDescriptor{.name = "smooth_limit_deg",
                        .unit = "deg",
                        .preset = 22.5,
                        .min = 0,
                        .max = 90,
                        .help = {"Largest incidence at which a smooth surface answers",
                                 "Mayor incidencia con que responde una superficie lisa"}},
    ParameterDescriptor{.name = "soft_limit_deg",
                        .unit = "deg",
                        .preset = 45,
                        .min = 0,
                        .max = 90,
                        .help = {"Largest incidence at which a soft surface answers",
                                 "Mayor incidencia con que responde una superficie blanda"},
                        .ours = true},
    ParameterDescriptor{.name = "soft_range",
                        .preset = 0.5,
                        .min = 0,
                        .max = 1,
                        .help = {"Share of the reach within which soft surfaces answer",
                                 "Parte del alcance en que responden superficies blandas"},
                        .ours = true},
    ParameterDescriptor{.name = "mirror_bounces",
                        .type = ParameterType::Integer,
                        .preset = 1,
                        .min = 0,
                        .max = 8,
                        .help = {"How often a ray without echo goes on along its mirror direction; 0 = no phantoms",
                                 "Cuántas veces sigue un rayo sin eco en su dirección reflejada; 0 = sin fantasmas"},
                        .ours = true},
    ParameterDescriptor{.name = "crosstalk",
                        .type = ParameterType::Boolean,
                        .help = {"Whether it hears the robot's other sonars that fire at the same moment",
                                 "Si oye los otros sonares del robot que disparan a la vez"},
                        .ours = true},
    ParameterDescriptor{.name = "air_C",
                        .unit = "degC",
                        .preset = 20,
                        .min = -60,
                        .max = 80,
                        .help = {"Temperature of the air", "Temperatura del aire"}},
    ParameterDescriptor{.name = "assumed_C",
                        .unit = "degC",
                        .preset = 20,
                        .min = -60,
                        .max = 80,
                        .help = {"Temperature the device assumes when it gives a range",
                                 "Temperatura que supone el sensor al dar la distancia"}},
    ParameterDescriptor{.name = "no_echo_s",
                        .unit = "s",
                        .preset = 0.0191,
                        .min = 0,
                        .max = 1,
                        .help = {"Echo time given when nothing answers: the PING's 3.29 m",
                                 "Tiempo de eco que da si nada responde: los 3.29 m del PING"}},
    ParameterDescriptor{.name = "too_close_echo_s",
                        .unit = "s",
                        .preset = 115e-6,
                        .min = 0,
                        .max = 1,
                        .help = {"Echo time given in the blind zone: the PING's shortest pulse",
                                 "Tiempo de eco que da en la zona ciega: el pulso más corto del PING"}},
    ParameterDescriptor{.name = "too_close",
                        .type = ParameterType::Choice,
                        .choices = kTooClose,
                        .help = {"What range says in the blind zone", "Qué da range en la zona ciega"}},
};

/// What is fixed of a device; what its documentation does not give is ours.
struct DeviceDefaults {
  double cone_deg, min_range_m, max_range_m, resolution_m, no_echo_s, too_close_echo_s;
  TooClose too_close;
};
constexpr std::array<DeviceDefaults, 3> kDeviceDefaults = {{
    {40, 0.02, 3, 0.001, 0.0191, 115e-6, TooClose::MinusInfinity},
    // Whole centimetres; 65 ms of listening. It gives its shortest range for whatever is nearer.
    {50, 0.16, 6, 0.01, 0.065, 932e-6, TooClose::Minimum},
    // Deaf for 2.38 ms while the transducer rings; 6 in to 35 ft by its maker's word, 0.41 m without further circuits.
    {30, 0.41, 10.7, 0.003, 0.0625, 2.38e-3, TooClose::MinusInfinity},
}};

SonarConfig config_of(const Parameters& parameters) {
  const DeviceDefaults& device = kDeviceDefaults[static_cast<std::size_t>(parameters.choice_index("device"))];
  const auto of = [&](std::string_view name, double preset) {
    return parameters.given(name) ? parameters.real(name) : preset;
  };
  SonarConfig config;
  config.cone = Angle::from_deg(of("cone_deg", device.cone_deg));
  config.fading = parameters.boolean("fading");
  config.rays = parameters.integer("rays");
  config.min_range_m = of("min_range_m", device.min_range_m);
  config.max_range_m = of("max_range_m", device.max_range_m);
  config.noise_m = parameters.real("noise_m");
  config.resolution_m = of("resolution_m", device.resolution_m);
  config.dropout = parameters.real("dropout");
  config.incidence_limit = {Angle::from_deg(parameters.real("rough_limit_deg")),
                            Angle::from_deg(parameters.real("smooth_limit_deg")),
                            Angle::from_deg(parameters.real("soft_limit_deg"))};
  config.soft_range = parameters.real("soft_range");
  config.mirror_bounces = parameters.integer("mirror_bounces");
  config.crosstalk = parameters.boolean("crosstalk");
  config.air_C = parameters.real("air_C");
  config.assumed_C = parameters.real("assumed_C");
  config.no_echo_s = of("no_echo_s", device.no_echo_s);
  config.too_close_echo_s = of("too_close_echo_s", device.too_close_echo_s);
  const auto chosen = static_cast<TooClose>(parameters.choice_index("too_close"));
  config.too_close = parameters.given("too_close") ? chosen : device.too_close;
  return config;
}

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  const SonarConfig config = config_of(parameters);
  if (config.min_range_m >= config.max_range_m) {
    return fail(ErrorCode::BadParameter,
                {"min_range_m is {}, must be less than max_range_m = {}",
                 "min_range_m es {}, debe ser menor que max_range_m = {}"},
                config.min_range_m, config.max_range_m);
  }
  return std::make_unique<Sonar>(config);
}

}  // namespace

extern constinit const SensorKind sonar_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Sonar",
                   .summary = {"Ultrasonic ranger with a cone, mirror reflections and a blind zone",
                               "Medidor ultrasónico con haz, reflexiones especulares y zona ciega"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Kuc and Siegel (1987) for mirror reflection; defaults of the Parallax PING"},
    .make = make};

}  // namespace ganglion::sim
