// What the graph, the studio's palette, the manual and the exporter know of this kind.
#include <array>

#include "ganglion/acting/dynamic_map_router/dynamic_map_router.h"

namespace ganglion {
namespace {

constexpr std::array<ElementDescriptor, 2> kColumnRow = {"column", "row"};
constexpr std::array<ElementDescriptor, 2> kXY = {"x", "y"};
constexpr std::array<ElementDescriptor, 2> kMotionDirection = {"motion", "direction"};
constexpr std::array<std::string_view, 2> kSecureBy = {"cost", "length"};

constexpr PortDescriptor signal(std::string_view name, std::string_view unit, ValueType type, Text help) {
  return {.name = name, .role = PortRole::Output, .unit = unit, .type = type, .help = help};
}

constexpr std::array kPorts = {
    PortDescriptor{.name = "goal",
                   .role = PortRole::Request,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow,
                   .help = {"Cell to reach", "Celda que se debe alcanzar"}},
    PortDescriptor{.name = "cell",
                   .role = PortRole::Feedback,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow,
                   .help = {"Cell reached", "Celda alcanzada"}},
    PortDescriptor{.name = "position",
                   .role = PortRole::Feedback,
                   .unit = "m",
                   .size = 2,
                   .elements = kXY,
                   .required = false,
                   .help = {"Position in the map's frame; shows how far the goal is",
                            "Posición en el marco del mapa; muestra a qué distancia está el objetivo"}},
    PortDescriptor{.name = "heading",
                   .role = PortRole::Feedback,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"Heading in the map's frame, rounded to 45 deg. When lost, the one the last step needed",
                            "Rumbo en el marco del mapa, redondeado a 45 grados. Si se pierde, el del último paso"}},
    PortDescriptor{.name = "contact",
                   .role = PortRole::Feedback,
                   .type = ValueType::Discrete,
                   .required = false,
                   .help = {"Not 0 when something was touched; a failed step that touched nothing counts half",
                            "Distinto de 0 si se tocó algo; un paso fallido sin contacto cuenta la mitad"}},
    PortDescriptor{.name = "goal_direction",
                   .role = PortRole::Feedback,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .required = false,
                   .help = {"Direction of the goal where the robot senses it; goal_error follows it",
                            "Dirección del objetivo si el robot la percibe; goal_error la sigue"}},
    PortDescriptor{.name = "step",
                   .role = PortRole::Command,
                   .size = 2,
                   .elements = kMotionDirection,
                   .help = {"One step: motion 1 forward, -1 backward; direction of travel in the map's frame [rad], a "
                            "multiple of 45 deg",
                            "Un paso: motion 1 adelante, -1 atrás; dirección de avance en el marco del mapa [rad], "
                            "múltiplo de 45 grados"}},
    PortDescriptor{.name = "appraisal",
                   .role = PortRole::Appraisal,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow,
                   .required = false,
                   .help = {"Cell expected at the next tick", "Celda esperada en el próximo ciclo"}},
    signal("risk_ahead", "", ValueType::Real, {"Risk of the cell of this step", "Riesgo de la celda de este paso"}),
    signal("route_length", "m", ValueType::Real, {"Length of the route left", "Longitud restante de la ruta"}),
    signal("phase", "", ValueType::Discrete,
           {"0 idle, 1 secure route, 2 feasible route, 3 going back, 4 waiting",
            "0 en reposo, 1 ruta segura, 2 ruta factible, 3 retrocede, 4 espera"}),
    signal("explored", "", ValueType::Discrete, {"Cells explored", "Celdas exploradas"}),
    signal("occupied", "", ValueType::Discrete, {"Cells labelled occupied", "Celdas marcadas como ocupadas"}),
    signal("failures", "", ValueType::Discrete,
           {"Steps of this request that failed", "Pasos de esta solicitud que fallaron"}),
    signal("rounds", "", ValueType::Discrete,
           {"Rounds in which every route failed", "Rondas en que fallaron todas las rutas"}),
    signal("goal_distance", "m", ValueType::Real,
           {"Distance from the position to the goal's centre", "Distancia de la posición al centro del objetivo"}),
    signal("goal_error", "rad", ValueType::Circular,
           {"Direction of the goal from the heading", "Dirección del objetivo respecto del rumbo"}),
};

constexpr ParameterDescriptor ours(std::string_view name, std::string_view unit, double preset, double min, double max,
                                   Text help) {
  return {.name = name, .unit = unit, .preset = preset, .min = min, .max = max, .help = help, .ours = true};
}
constexpr ParameterDescriptor our_count(std::string_view name, std::string_view unit, double preset, double min,
                                        double max, Text help) {
  ParameterDescriptor result = ours(name, unit, preset, min, max, help);
  result.type = ParameterType::Integer;
  return result;
}

constexpr std::array kParameters = {
    ParameterDescriptor{
        .name = "cell_m",
        .unit = "m",
        .preset = 0.5,
        .min = 0.001,
        .max = 1000,
        .help = {"Side of a cell: the robot's largest dimension", "Lado de una celda: la mayor dimensión del robot"}},
    ParameterDescriptor{.name = "max_turn_deg",
                        .type = ParameterType::Integer,
                        .unit = "deg",
                        .preset = 45,
                        .min = 45,
                        .max = 180,
                        .help = {"Most that one step may turn the heading: 45, 90 or 180 (turns on the spot)",
                                 "Giro máximo de un paso: 45, 90 o 180 (gira sobre sí mismo)"}},
    our_count("max_tiles", "", 64, 1, 4096,
              {"Tiles of 64 x 64 cells the map may grow to (128 KiB each); then ground outside them is closed",
               "Bloques de 64 x 64 celdas hasta los que crece el mapa (128 KiB cada uno); lo de fuera queda cerrado"}),
    our_count("window_cells", "", 128, 16, 1024,
              {"Side of the square within which a route is sought, its middle between robot and goal",
               "Lado del cuadrado en que se busca la ruta, centrado entre el robot y el objetivo"}),
    ours("secure_risk", "", 0.2, 0, 0.999, {"Most risk in a secure route", "Riesgo máximo de una ruta segura"}),
    ours("first_risk", "", 0.2, 0, 0.999,
         {"Risk of a cell found blocked, and the least after a failure",
          "Riesgo de una celda hallada bloqueada, y el mínimo tras un fallo"}),
    ours("failure_step", "", 0.15, 0, 0.999,
         {"A failure adds this part of 1 - risk", "Un fallo suma esta parte de 1 - riesgo"}),
    ours("static_relief", "", 0.3, 0, 1,
         {"Crossing a static cell multiplies its risk by this",
          "Cruzar una celda estática multiplica su riesgo por esto"}),
    ours("dynamic_relief", "", 0.7, 0, 1,
         {"Crossing a dynamic cell multiplies its risk by this",
          "Cruzar una celda dinámica multiplica su riesgo por esto"}),
    our_count("inhibition_base", "ticks", 2, 0, 1000,
              {"After a failure a cell stays closed for base + floor(span * risk)",
               "Tras un fallo la celda queda cerrada base + floor(span * riesgo)"}),
    our_count("inhibition_span", "ticks", 18, 0, 1000, {"See inhibition_base", "Véase inhibition_base"}),
    ours("risk_weight", "", 4, 0, 1000,
         {"Feasible routes minimise cost - weight * ln(1 - risk), in cells",
          "Las rutas factibles minimizan costo - peso * ln(1 - riesgo), en celdas"}),
    ParameterDescriptor{
        .name = "infer_walls",
        .type = ParameterType::Boolean,
        .preset = 1,
        .help = {"Unexplored cells beside, between or in line with occupied ones are thought risky; off: "
                 "all unexplored ground counts as free, as in the papers",
                 "Las celdas inexploradas junto a ocupadas, entre ellas o en su línea se creen "
                 "riesgosas; sin esto todo lo inexplorado cuenta como libre, como en los artículos"},
        .ours = true},
    ours("unexplored_weight", "", 3, 0, 1000,
         {"Like risk_weight, for unexplored cells; less is more curious",
          "Como risk_weight, para celdas inexploradas; con menos explora más"}),
    ours("open_risk", "", 0.1, 0, 0.999,
         {"Risk of an unexplored cell with nothing known near it",
          "Riesgo de una celda inexplorada sin nada conocido cerca"}),
    ours("beside_risk", "", 0.3, 0, 0.999,
         {"Risk of an unexplored cell next to an occupied one, or in line with three",
          "Riesgo de una celda inexplorada junto a una ocupada, o en línea con tres"}),
    ours(
        "between_risk", "", 0.8, 0, 0.999,
        {"Risk of an unexplored cell between two occupied ones", "Riesgo de una celda inexplorada entre dos ocupadas"}),
    our_count("wall_reach_cells", "", 12, 1, 64,
              {"How far a line of occupied cells is looked for", "Hasta dónde se busca una línea de celdas ocupadas"}),
    ours("backward_weight", "", 2, 1, 100,
         {"A step backwards counts as this many forwards", "Un paso atrás cuenta como tantos adelante"}),
    ParameterDescriptor{.name = "secure_by",
                        .type = ParameterType::Choice,
                        .choices = kSecureBy,
                        .help = {"What secure routes minimise: learned cost, or length alone",
                                 "Qué minimizan las rutas seguras: el costo aprendido o solo la longitud"},
                        .ours = true},
    our_count("dynamic_tries", "", 3, 1, 100,
              {"Attempts that a dynamic cell gets in one round; a static one gets one",
               "Intentos de una celda dinámica en cada ronda; una estática tiene uno"}),
    our_count("go_back_steps", "", 50, 0, 100000,
              {"Steps remembered for going back", "Pasos recordados para retroceder"}),
    our_count("rounds", "", 3, 1, 1000,
              {"Rounds of trying everything before withdrawing", "Rondas de intentarlo todo antes de retirarse"}),
    ours("patience_s", "s", 5, 0, 3600,
         {"Time without a known cell before withdrawing", "Tiempo sin celda conocida antes de retirarse"}),
};

Result<std::unique_ptr<ActingModule>> make(const Parameters& parameters) {
  const auto ticks = [&](std::string_view name) { return static_cast<std::uint32_t>(parameters.integer(name)); };
  const int turn_deg = parameters.integer("max_turn_deg");
  if (turn_deg != 45 && turn_deg != 90 && turn_deg != 180) {
    return fail(ErrorCode::BadParameter,
                {"max_turn_deg is {}, must be 45, 90 or 180", "max_turn_deg es {}, debe ser 45, 90 o 180"}, turn_deg);
  }
  const DynamicMapRouterConfig config{
      .cell_m = parameters.real("cell_m"),
      .max_tiles = parameters.integer("max_tiles"),
      .risk = {.first_risk = parameters.real("first_risk"),
               .failure_step = parameters.real("failure_step"),
               .static_relief = parameters.real("static_relief"),
               .dynamic_relief = parameters.real("dynamic_relief"),
               .inhibition_base = ticks("inhibition_base"),
               .inhibition_span = ticks("inhibition_span")},
      .price = {.secure_risk = parameters.real("secure_risk"),
                .risk_weight = parameters.real("risk_weight"),
                .secure_weighs_cost = parameters.choice_index("secure_by") == 0,
                .unexplored = {.inferred = parameters.boolean("infer_walls"),
                               .weight = parameters.real("unexplored_weight"),
                               .open_risk = parameters.real("open_risk"),
                               .beside_risk = parameters.real("beside_risk"),
                               .between_risk = parameters.real("between_risk"),
                               .wall_reach_cells = parameters.integer("wall_reach_cells")}},
      .router = {.window_cells = parameters.integer("window_cells"),
                 .max_turn = turn_deg / 45,
                 .backward_weight = parameters.real("backward_weight")},
      .dynamic_tries = parameters.integer("dynamic_tries"),
      .go_back_steps = parameters.integer("go_back_steps"),
      .rounds = parameters.integer("rounds"),
      .patience_s = parameters.real("patience_s"),
  };
  auto made = DynamicMapRouter::make(config);
  if (!made) return tl::unexpected<Error>(made.error());
  return std::unique_ptr<ActingModule>(std::move(*made));
}

}  // namespace

extern constinit const ActingModuleKind dynamic_map_router_kind{
    .descriptor = {.component_class = ComponentClass::Acting,
                   .name = "DynamicMapRouter",
                   .paper_name = "AmDmr",
                   .summary = {"Maps the ground while driving over it, and routes the robot to a requested cell",
                               "Mapea el terreno mientras lo recorre y lleva el robot a la celda solicitada"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "A growing functional modules locomotion subsystem, Methodology 1 and Algorithm 2"},
    .make = make};

}  // namespace ganglion
