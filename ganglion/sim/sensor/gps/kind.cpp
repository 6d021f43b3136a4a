#include "ganglion/sim/sensor/gps/gps.h"

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kCoordinates = {"x", "y"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "position",
                   .role = PortRole::Output,
                   .unit = "m",
                   .size = 2,
                   .elements = kCoordinates,
                   .help = {"The fix on the world's ground plane", "La posición en el plano del mundo"}},
    PortDescriptor{
        .name = "latitude", .role = PortRole::Output, .unit = "deg", .help = {"North of the equator", "Latitud norte"}},
    PortDescriptor{
        .name = "longitude", .role = PortRole::Output, .unit = "deg", .help = {"East of Greenwich", "Longitud este"}},
    PortDescriptor{.name = "altitude",
                   .role = PortRole::Output,
                   .unit = "m",
                   .help = {"Above the ellipsoid", "Sobre el elipsoide"}},
    PortDescriptor{.name = "course",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"Course over ground in the world, counter-clockwise from x; nan when slow",
                            "Rumbo sobre el suelo en el mundo, antihorario desde x; nan si va lento"}},
    PortDescriptor{.name = "speed",
                   .role = PortRole::Output,
                   .unit = "m/s",
                   .help = {"Speed over ground", "Velocidad sobre el suelo"}},
    PortDescriptor{.name = "utc",
                   .role = PortRole::Output,
                   .unit = "s",
                   .help = {"Seconds since 1970-01-01 UTC", "Segundos desde 1970-01-01 UTC"}},
    PortDescriptor{.name = "fix",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"1 with a fix, else 0", "1 si hay posición, si no 0"}},
};

constexpr ParameterDescriptor real(std::string_view name, std::string_view unit, double preset, double min, double max,
                                   Text help) {
  return {.name = name, .unit = unit, .preset = preset, .min = min, .max = max, .help = help, .ours = true};
}

constexpr std::array kParameters = {
    real("latitude_deg", "deg", 6.25, -89, 89, {"Of the world's origin", "Del origen del mundo"}),
    real("longitude_deg", "deg", -75.57, -180, 180, {"Of the world's origin", "Del origen del mundo"}),
    real("altitude_m", "m", 1500, -1000, 50000, {"Of the world's origin", "Del origen del mundo"}),
    real("north_deg", "deg", 90, -360, 360,
         {"Direction of true north in the world, counter-clockwise from x",
          "Dirección del norte geográfico en el mundo, antihorario desde x"}),
    real("utc_s", "s", 1767225600, 0, 1e11,
         {"When an episode begins, since 1970; preset: 2026-01-01", "Comienzo del episodio, desde 1970; 2026-01-01"}),
    real("noise_m", "m", 0.5, 0, 1000,
         {"Standard deviation of one fix, each way", "Desviación típica de una posición, en cada sentido"}),
    real("drift_m", "m", 1.5, 0, 1000,
         {"Standard deviation of the slow error, each way", "Desviación típica del error lento, en cada sentido"}),
    real("drift_s", "s", 120, 1e-3, 1e6,
         {"Correlation time of the slow error", "Tiempo de correlación del error lento"}),
    real("vertical_factor", "", 1.5, 0, 100,
         {"Errors of the altitude over those along the ground", "Error de altitud entre el error en el plano"}),
    real("velocity_noise_mps", "m/s", 0.05, 0, 100,
         {"Standard deviation of the velocity, each way", "Desviación típica de la velocidad, en cada sentido"}),
    real("course_from_mps", "m/s", 0.1, 0, 100,
         {"Slower than that there is no course", "Más lento que eso no hay rumbo"}),
    real("lost_every_s", "s", 0, 0, 1e9,
         {"Mean time between spells without a fix; 0 = never lost",
          "Tiempo medio entre pérdidas de señal; 0 = nunca se pierde"}),
    real("lost_for_s", "s", 10, 1e-3, 1e9, {"Mean length of such a spell", "Duración media de una pérdida"}),
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  const auto degrees = [&](std::string_view name) { return Angle::from_deg(parameters.real(name)); };
  GpsConfig config;
  config.datum = {degrees("latitude_deg"), degrees("longitude_deg"), parameters.real("altitude_m"),
                  degrees("north_deg"), parameters.real("utc_s")};
  config.noise_m = parameters.real("noise_m");
  config.drift_m = parameters.real("drift_m");
  config.drift_s = parameters.real("drift_s");
  config.vertical_factor = parameters.real("vertical_factor");
  config.velocity_noise_mps = parameters.real("velocity_noise_mps");
  config.course_from_mps = parameters.real("course_from_mps");
  config.lost_every_s = parameters.real("lost_every_s");
  config.lost_for_s = parameters.real("lost_for_s");
  return std::make_unique<Gps>(config);
}

}  // namespace

extern constinit const SensorKind gps_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Gps",
                   .summary = {"Satellite receiver with noise, slow drift and spells without a fix",
                               "Receptor satelital con ruido, deriva lenta y pérdidas de señal"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "WGS 84 for the radii; Gauss-Markov drift after Brown and Hwang; numbers ours"},
    .make = make};

}  // namespace ganglion::sim
