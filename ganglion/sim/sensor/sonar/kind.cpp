#include "ganglion/sim/sensor/sonar/sonar.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "range",
                   .title = {"range", "distancia"},
                   .help = {"Range of the echo; inf = none, -inf = too close, nan = dead",
                            "Distancia del eco; inf = ninguno, -inf = demasiado cerca, nan = averiado"},
                   .role = PortRole::Output,
                   .unit = "m"},
    PortDescriptor{.name = "echo_time",
                   .title = {"echo time", "tiempo de eco"},
                   .help = {"Time of the echo there and back, as the device measures it; 0 = no pulse",
                            "Tiempo de ida y vuelta del eco, como lo mide el sensor; 0 = sin pulso"},
                   .role = PortRole::Output,
                   .unit = "s"},
};

constexpr std::array<std::string_view, 3> kDevices = {"PING", "SRF02", "Polaroid"};
constexpr std::array<std::string_view, 2> kTooClose = {"minus_infinity", "minimum"};

/// The limit of a material, by its number.
template <std::size_t N>
constexpr auto kIncidenceLimit = [](SonarConfig& config) -> auto& {
  return config.incidence_limit[N];
};

constexpr std::array kParameters = {
    parameter<SonarConfig, &SonarConfig::device>(
        {.name = "device",
         .title = {"device", "dispositivo"},
         .help = {"Sets the defaults of cone, range, resolution, echo times and blind zone",
                  "Fija los valores de haz, alcance, resolución, tiempos de eco y zona ciega"},
         .choices = kDevices}),
    parameter<SonarConfig, &SonarConfig::cone>(
        {.name = "cone_deg",
         .title = {"cone angle", "ángulo del haz"},
         .help = {"Full opening angle (-6 dB): PING 40, SRF02 50, Polaroid 30",
                  "Ángulo total del haz (-6 dB): PING 40, SRF02 50, Polaroid 30"},
         .unit = "deg",
         .min = 0,
         .max = 180}),
    parameter<SonarConfig, &SonarConfig::fading>(
        {.name = "fading",
         .title = {"off-axis fading", "atenuación lateral"},
         .help = {"Whether echoes from the rim of the cone are weaker and so heard only from nearer",
                  "Si los ecos del borde del haz son más débiles y solo se oyen desde más cerca"},
         .ours = true}),
    parameter<SonarConfig, &SonarConfig::rays>({.name = "rays",
                                                .title = {"rays", "rayos"},
                                                .help = {"Rays spread over the cone", "Rayos repartidos en el haz"},
                                                .min = 1,
                                                .max = 63,
                                                .ours = true}),
    parameter<SonarConfig, &SonarConfig::min_range_m>(
        {.name = "min_range_m",
         .title = {"minimum range", "alcance mínimo"},
         .help = {"End of the blind zone: PING 0.02, SRF02 0.16, Polaroid 0.41",
                  "Fin de la zona ciega: PING 0.02, SRF02 0.16, Polaroid 0.41"},
         .unit = "m",
         .min = 0,
         .max = 100}),
    parameter<SonarConfig, &SonarConfig::max_range_m>(
        {.name = "max_range_m",
         .title = {"maximum range", "alcance máximo"},
         .help = {"Reach: PING 3, SRF02 6, Polaroid 10.7", "Alcance: PING 3, SRF02 6, Polaroid 10.7"},
         .unit = "m",
         .min = 1e-3,
         .max = 100}),
    parameter<SonarConfig, &SonarConfig::noise_m>(
        {.name = "noise_m",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "m",
         .min = 0,
         .max = 10,
         .live = true}),
    parameter<SonarConfig, &SonarConfig::resolution_m>(
        {.name = "resolution_m",
         .title = {"resolution", "resolución"},
         .help = {"Ranges are multiples of it; 0 = not rounded", "Las distancias son múltiplos; 0 = sin redondeo"},
         .unit = "m",
         .min = 0,
         .max = 10}),
    parameter<SonarConfig, &SonarConfig::dropout>(
        {.name = "dropout",
         .title = {"dropout probability", "probabilidad de pérdida"},
         .help = {"Probability that an echo is lost", "Probabilidad de perder un eco"},
         .min = 0,
         .max = 1,
         .ours = true,
         .live = true}),
    parameter<SonarConfig, kIncidenceLimit<0>>(
        {.name = "rough_limit_deg",
         .title = {"rough surface limit", "límite en rugosas"},
         .help = {"Largest incidence at which a rough surface answers; 90 = always",
                  "Mayor incidencia con que responde una superficie rugosa; 90 = siempre"},
         .unit = "deg",
         .min = 0,
         .max = 90,
         .ours = true}),
    parameter<SonarConfig, kIncidenceLimit<1>>({.name = "smooth_limit_deg",
                                                .title = {"smooth surface limit", "límite en lisas"},
                                                .help = {"Largest incidence at which a smooth surface answers",
                                                         "Mayor incidencia con que responde una superficie lisa"},
                                                .unit = "deg",
                                                .min = 0,
                                                .max = 90}),
    parameter<SonarConfig, kIncidenceLimit<2>>({.name = "soft_limit_deg",
                                                .title = {"soft surface limit", "límite en blandas"},
                                                .help = {"Largest incidence at which a soft surface answers",
                                                         "Mayor incidencia con que responde una superficie blanda"},
                                                .unit = "deg",
                                                .min = 0,
                                                .max = 90,
                                                .ours = true}),
    parameter<SonarConfig, &SonarConfig::soft_range>(
        {.name = "soft_range",
         .title = {"soft surface reach", "alcance en blandas"},
         .help = {"Share of the reach within which soft surfaces answer",
                  "Parte del alcance en que responden superficies blandas"},
         .min = 0,
         .max = 1,
         .ours = true}),
    parameter<SonarConfig, &SonarConfig::mirror_bounces>(
        {.name = "mirror_bounces",
         .title = {"mirror bounces", "rebotes especulares"},
         .help = {"How often a ray without echo goes on along its mirror direction; 0 = no phantoms",
                  "Cuántas veces sigue un rayo sin eco en su dirección reflejada; 0 = sin fantasmas"},
         .min = 0,
         .max = 8,
         .ours = true}),
    parameter<SonarConfig, &SonarConfig::crosstalk>(
        {.name = "crosstalk",
         .title = {"crosstalk", "diafonía"},
         .help = {"Whether it hears the robot's other sonars that fire at the same moment",
                  "Si oye los otros sonares del robot que disparan a la vez"},
         .ours = true}),
    parameter<SonarConfig, &SonarConfig::air_C>({.name = "air_C",
                                                 .title = {"air temperature", "temperatura del aire"},
                                                 .help = {"Temperature of the air", "Temperatura del aire"},
                                                 .unit = "degC",
                                                 .min = -60,
                                                 .max = 80}),
    parameter<SonarConfig, &SonarConfig::assumed_C>({.name = "assumed_C",
                                                     .title = {"assumed temperature", "temperatura supuesta"},
                                                     .help = {"Temperature the device assumes when it gives a range",
                                                              "Temperatura que supone el sensor al dar la distancia"},
                                                     .unit = "degC",
                                                     .min = -60,
                                                     .max = 80,
                                                     .live = true}),
    parameter<SonarConfig, &SonarConfig::no_echo_s>(
        {.name = "no_echo_s",
         .title = {"no-echo time", "tiempo sin eco"},
         .help = {"Echo time given when nothing answers: the PING's 3.29 m",
                  "Tiempo de eco que da si nada responde: los 3.29 m del PING"},
         .unit = "s",
         .min = 0,
         .max = 1}),
    parameter<SonarConfig, &SonarConfig::too_close_echo_s>(
        {.name = "too_close_echo_s",
         .title = {"blind zone time", "tiempo en zona ciega"},
         .help = {"Echo time given in the blind zone: the PING's shortest pulse",
                  "Tiempo de eco que da en la zona ciega: el pulso más corto del PING"},
         .unit = "s",
         .min = 0,
         .max = 1}),
    parameter<SonarConfig, &SonarConfig::too_close>(
        {.name = "too_close",
         .title = {"blind zone reading", "lectura en zona ciega"},
         .help = {"What range says in the blind zone", "Qué da range en la zona ciega"},
         .choices = kTooClose}),
};

/// What is fixed of a device; what its documentation does not give is ours.
SonarConfig config_of(SonarDevice device) {
  switch (device) {
    case SonarDevice::Srf02:
      // Whole centimetres; 65 ms of listening. It gives its shortest range for whatever is nearer.
      return {.cone = Angle::from_deg(50),
              .min_range_m = 0.16,
              .max_range_m = 6,
              .resolution_m = 0.01,
              .no_echo_s = 0.065,
              .too_close_echo_s = 932e-6,
              .too_close = TooClose::Minimum};
    case SonarDevice::Polaroid:
      // Deaf for 2.38 ms while the transducer rings; 6 in to 35 ft by its maker's word, 0.41 m without further circuits.
      return {.cone = Angle::from_deg(30),
              .min_range_m = 0.41,
              .max_range_m = 10.7,
              .resolution_m = 0.003,
              .no_echo_s = 0.0625,
              .too_close_echo_s = 2.38e-3};
    case SonarDevice::Ping:
      break;
  }
  return {};
}

}  // namespace

Result<void> Sonar::judge(SonarConfig& config, const Parameters& values) {
  const SonarConfig device = config_of(config.device);
  const auto take = [&](std::string_view name, auto member) {
    if (!values.given(name)) config.*member = device.*member;
  };
  take("cone_deg", &SonarConfig::cone);
  take("min_range_m", &SonarConfig::min_range_m);
  take("max_range_m", &SonarConfig::max_range_m);
  take("resolution_m", &SonarConfig::resolution_m);
  take("no_echo_s", &SonarConfig::no_echo_s);
  take("too_close_echo_s", &SonarConfig::too_close_echo_s);
  take("too_close", &SonarConfig::too_close);
  if (config.min_range_m >= config.max_range_m) {
    return fail(ErrorCode::BadParameter,
                {"min_range_m is {}, must be less than max_range_m = {}",
                 "min_range_m es {}, debe ser menor que max_range_m = {}"},
                config.min_range_m, config.max_range_m);
  }
  return {};
}

extern constinit const SensorKind sonar_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Sonar",
                   .summary = {"Ultrasonic ranger with a cone, mirror reflections and a blind zone",
                               "Medidor ultrasónico con haz, reflexiones especulares y zona ciega"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Kuc and Siegel (1987) for mirror reflection; defaults of the Parallax PING"},
    .make = make_bound<Sensor, Sonar, SonarConfig>};

}  // namespace ganglion::sim
