// What the graph, the studio's palette, the manual and the exporter know of this kind.
#include <array>

#include "ganglion/acting/dynamic_map_router/dynamic_map_router.h"

namespace ganglion {
namespace {

using Config = DynamicMapRouterConfig;

constexpr std::array<ElementDescriptor, 2> kColumnRow = {"column", "row"};
constexpr std::array<ElementDescriptor, 2> kXY = {"x", "y"};
constexpr std::array<ElementDescriptor, 2> kMotionDirection = {"motion", "direction"};
constexpr std::array<std::string_view, 2> kSecureBy = {"cost", "length"};

constexpr PortDescriptor signal(std::string_view name, Text title, Text help, std::string_view unit, ValueType type) {
  return {.name = name, .title = title, .help = help, .role = PortRole::Output, .unit = unit, .type = type};
}

constexpr std::array kPorts = {
    PortDescriptor{.name = "goal",
                   .title = {"goal", "celda objetivo"},
                   .help = {"Cell to reach", "Celda que se debe alcanzar"},
                   .role = PortRole::Request,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow},
    PortDescriptor{.name = "cell",
                   .title = {"cell", "celda"},
                   .help = {"Cell reached", "Celda alcanzada"},
                   .role = PortRole::Feedback,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow},
    PortDescriptor{.name = "position",
                   .title = {"position", "posición"},
                   .help = {"Position in the map's frame; shows how far the goal is",
                            "Posición en el marco del mapa; muestra a qué distancia está el objetivo"},
                   .role = PortRole::Feedback,
                   .unit = "m",
                   .size = 2,
                   .elements = kXY,
                   .required = false},
    PortDescriptor{.name = "heading",
                   .title = {"heading", "rumbo"},
                   .help = {"Heading in the map's frame, rounded to 45 deg. When lost, the one the last step needed",
                            "Rumbo en el marco del mapa, redondeado a 45 grados. Si se pierde, el del último paso"},
                   .role = PortRole::Feedback,
                   .unit = "rad",
                   .type = ValueType::Circular},
    PortDescriptor{.name = "contact",
                   .title = {"contact", "contacto"},
                   .help = {"Not 0 when something was touched; a failed step that touched nothing counts half",
                            "Distinto de 0 si se tocó algo; un paso fallido sin contacto cuenta la mitad"},
                   .role = PortRole::Feedback,
                   .type = ValueType::Discrete,
                   .required = false},
    PortDescriptor{.name = "goal_direction",
                   .title = {"goal direction", "dirección del objetivo"},
                   .help = {"Direction of the goal where the robot senses it; goal_error follows it",
                            "Dirección del objetivo si el robot la percibe; goal_error la sigue"},
                   .role = PortRole::Feedback,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .required = false},
    PortDescriptor{.name = "step",
                   .title = {"step", "paso"},
                   .help = {"One step: motion 1 forward, -1 backward; direction of travel in the map's frame [rad], a "
                            "multiple of 45 deg",
                            "Un paso: motion 1 adelante, -1 atrás; dirección de avance en el marco del mapa [rad], "
                            "múltiplo de 45 grados"},
                   .role = PortRole::Command,
                   .size = 2,
                   .elements = kMotionDirection},
    PortDescriptor{.name = "appraisal",
                   .title = {"appraisal", "evaluación"},
                   .help = {"Cell expected at the next tick", "Celda esperada en el próximo ciclo"},
                   .role = PortRole::Appraisal,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow,
                   .required = false},
    signal("risk_ahead", {"risk ahead", "riesgo delante"},
           {"Risk of the cell of this step", "Riesgo de la celda de este paso"}, "", ValueType::Real),
    signal("route_length", {"route length", "longitud de ruta"},
           {"Length of the route left", "Longitud restante de la ruta"}, "m", ValueType::Real),
    signal("phase", {"phase", "fase"},
           {"0 idle, 1 secure route, 2 feasible route, 3 going back, 4 waiting",
            "0 en reposo, 1 ruta segura, 2 ruta factible, 3 retrocede, 4 espera"},
           "", ValueType::Discrete),
    signal("explored", {"explored cells", "celdas exploradas"}, {"Cells explored", "Celdas exploradas"}, "",
           ValueType::Discrete),
    signal("occupied", {"occupied cells", "celdas ocupadas"},
           {"Cells labelled occupied", "Celdas marcadas como ocupadas"}, "", ValueType::Discrete),
    signal("failures", {"failures", "fallos"},
           {"Steps of this request that failed", "Pasos de esta solicitud que fallaron"}, "", ValueType::Discrete),
    signal("rounds", {"rounds", "rondas"},
           {"Rounds in which every route failed", "Rondas en que fallaron todas las rutas"}, "", ValueType::Discrete),
    signal("goal_distance", {"goal distance", "distancia al objetivo"},
           {"Distance from the position to the goal's centre", "Distancia de la posición al centro del objetivo"}, "m",
           ValueType::Real),
    signal("goal_error", {"goal error", "error al objetivo"},
           {"Direction of the goal from the heading", "Dirección del objetivo respecto del rumbo"}, "rad",
           ValueType::Circular),
};

/// A member of a member of the configuration: ((config.*A).*B).*C.
template <auto... Path>
constexpr auto within = [](Config& config) -> auto& {
  return (config.*....*Path);
};

constexpr std::array<double, 3> kTurns = {45, 90, 180};

constexpr std::array<std::string_view, 1> kRestsOn = {"cell_m"};

constexpr std::array kParameters = {
    parameter<Config, &Config::cell_m>(
        {.name = "cell_m",
         .title = {"cell side", "lado de celda"},
         .help = {"Side of a cell: the robot's largest dimension", "Lado de una celda: la mayor dimensión del robot"},
         .unit = "m",
         .min = 0.001,
         .max = 1000}),
    parameter<Config, &Config::max_turn_deg>(
        {.name = "max_turn_deg",
         .title = {"largest turn", "giro máximo"},
         .help = {"Most that one step may turn the heading: 45, 90 or 180 (turns on the spot)",
                  "Giro máximo de un paso: 45, 90 o 180 (gira sobre sí mismo)"},
         .unit = "deg",
         .allowed = kTurns}),
    parameter<Config, &Config::max_tiles>(
        {.name = "max_tiles",
         .title = {"most tiles", "bloques máximos"},
         .help =
             {"Tiles of 64 x 64 cells the map may grow to (128 KiB each); then ground outside them is closed",
              "Bloques de 64 x 64 celdas hasta los que crece el mapa (128 KiB cada uno); lo de fuera queda cerrado"},
         .min = 1,
         .max = 4096,
         .ours = true}),
    parameter<Config, within<&Config::router, &grid::RouterRule::window_cells>>(
        {.name = "window_cells",
         .title = {"window side", "lado de ventana"},
         .help = {"Side of the square within which a route is sought, its middle between robot and goal",
                  "Lado del cuadrado en que se busca la ruta, centrado entre el robot y el objetivo"},
         .min = 16,
         .max = 1024,
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::secure_risk>>(
        {.name = "secure_risk",
         .title = {"secure risk", "riesgo seguro"},
         .help = {"Most risk in a secure route", "Riesgo máximo de una ruta segura"},
         .min = 0,
         .max = 0.999,
         .ours = true}),
    parameter<Config, within<&Config::risk, &grid::RiskRule::first_risk>>(
        {.name = "first_risk",
         .title = {"first risk", "primer riesgo"},
         .help = {"Risk of a cell found blocked, and the least after a failure",
                  "Riesgo de una celda hallada bloqueada, y el mínimo tras un fallo"},
         .min = 0,
         .max = 0.999,
         .ours = true}),
    parameter<Config, within<&Config::risk, &grid::RiskRule::failure_step>>(
        {.name = "failure_step",
         .title = {"failure step", "paso por fallo"},
         .help = {"A failure adds this part of 1 - risk", "Un fallo suma esta parte de 1 - riesgo"},
         .min = 0,
         .max = 0.999,
         .ours = true}),
    parameter<Config, within<&Config::risk, &grid::RiskRule::static_relief>>(
        {.name = "static_relief",
         .title = {"static relief", "alivio estático"},
         .help = {"Crossing a static cell multiplies its risk by this",
                  "Cruzar una celda estática multiplica su riesgo por esto"},
         .min = 0,
         .max = 1,
         .ours = true}),
    parameter<Config, within<&Config::risk, &grid::RiskRule::dynamic_relief>>(
        {.name = "dynamic_relief",
         .title = {"dynamic relief", "alivio dinámico"},
         .help = {"Crossing a dynamic cell multiplies its risk by this",
                  "Cruzar una celda dinámica multiplica su riesgo por esto"},
         .min = 0,
         .max = 1,
         .ours = true}),
    parameter<Config, within<&Config::risk, &grid::RiskRule::inhibition_base>>(
        {.name = "inhibition_base",
         .title = {"inhibition base", "inhibición mínima"},
         .help = {"After a failure a cell stays closed for base + floor(span * risk)",
                  "Tras un fallo la celda queda cerrada base + floor(span * riesgo)"},
         .unit = "ticks",
         .min = 0,
         .max = 1000,
         .ours = true}),
    parameter<Config, within<&Config::risk, &grid::RiskRule::inhibition_span>>(
        {.name = "inhibition_span",
         .title = {"inhibition span", "margen de inhibición"},
         .help = {"See inhibition_base", "Véase inhibition_base"},
         .unit = "ticks",
         .min = 0,
         .max = 1000,
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::risk_weight>>(
        {.name = "risk_weight",
         .title = {"risk weight", "peso del riesgo"},
         .help = {"Feasible routes minimise cost - weight * ln(1 - risk), in cells",
                  "Las rutas factibles minimizan costo - peso * ln(1 - riesgo), en celdas"},
         .min = 0,
         .max = 1000,
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::unexplored, &grid::UnexploredRule::inferred>>(
        {.name = "infer_walls",
         .title = {"infer walls", "inferir paredes"},
         .help = {"Unexplored cells beside, between or in line with occupied ones are thought risky; off: "
                  "all unexplored ground counts as free, as in the papers",
                  "Las celdas inexploradas junto a ocupadas, entre ellas o en su línea se creen "
                  "riesgosas; sin esto todo lo inexplorado cuenta como libre, como en los artículos"},
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::unexplored, &grid::UnexploredRule::weight>>(
        {.name = "unexplored_weight",
         .title = {"unexplored weight", "peso de inexploradas"},
         .help = {"Like risk_weight, for unexplored cells; less is more curious",
                  "Como risk_weight, para celdas inexploradas; con menos explora más"},
         .min = 0,
         .max = 1000,
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::unexplored, &grid::UnexploredRule::open_risk>>(
        {.name = "open_risk",
         .title = {"open risk", "riesgo abierto"},
         .help = {"Risk of an unexplored cell with nothing known near it",
                  "Riesgo de una celda inexplorada sin nada conocido cerca"},
         .min = 0,
         .max = 0.999,
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::unexplored, &grid::UnexploredRule::beside_risk>>(
        {.name = "beside_risk",
         .title = {"beside risk", "riesgo al lado"},
         .help = {"Risk of an unexplored cell next to an occupied one, or in line with three",
                  "Riesgo de una celda inexplorada junto a una ocupada, o en línea con tres"},
         .min = 0,
         .max = 0.999,
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::unexplored, &grid::UnexploredRule::between_risk>>(
        {.name = "between_risk",
         .title = {"between risk", "riesgo entre ocupadas"},
         .help = {"Risk of an unexplored cell between two occupied ones",
                  "Riesgo de una celda inexplorada entre dos ocupadas"},
         .min = 0,
         .max = 0.999,
         .ours = true}),
    parameter<Config, within<&Config::price, &grid::PriceRule::unexplored, &grid::UnexploredRule::wall_reach_cells>>(
        {.name = "wall_reach_cells",
         .title = {"wall reach", "alcance de pared"},
         .help = {"How far a line of occupied cells is looked for",
                  "Hasta dónde se busca una línea de celdas ocupadas"},
         .min = 1,
         .max = 64,
         .ours = true}),
    parameter<Config, within<&Config::router, &grid::RouterRule::backward_weight>>(
        {.name = "backward_weight",
         .title = {"backward weight", "peso hacia atrás"},
         .help = {"A step backwards counts as this many forwards", "Un paso atrás cuenta como tantos adelante"},
         .min = 1,
         .max = 100,
         .ours = true}),
    parameter<Config, &Config::secure_by>(
        {.name = "secure_by",
         .title = {"secure criterion", "criterio de seguras"},
         .help = {"What secure routes minimise: learned cost, or length alone",
                  "Qué minimizan las rutas seguras: el costo aprendido o solo la longitud"},
         .choices = kSecureBy,
         .ours = true}),
    parameter<Config, &Config::dynamic_tries>(
        {.name = "dynamic_tries",
         .title = {"dynamic tries", "intentos dinámicos"},
         .help = {"Attempts that a dynamic cell gets in one round; a static one gets one",
                  "Intentos de una celda dinámica en cada ronda; una estática tiene uno"},
         .min = 1,
         .max = 100,
         .ours = true}),
    parameter<Config, &Config::go_back_steps>(
        {.name = "go_back_steps",
         .title = {"steps remembered", "pasos recordados"},
         .help = {"Steps remembered for going back", "Pasos recordados para retroceder"},
         .min = 0,
         .max = 100000,
         .ours = true}),
    parameter<Config, &Config::rounds>(
        {.name = "rounds",
         .title = {"rounds", "rondas"},
         .help = {"Rounds of trying everything before withdrawing", "Rondas de intentarlo todo antes de retirarse"},
         .min = 1,
         .max = 1000,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::patience_s>(
        {.name = "patience_s",
         .title = {"patience", "paciencia"},
         .help = {"Time without a known cell before withdrawing", "Tiempo sin celda conocida antes de retirarse"},
         .unit = "s",
         .min = 0,
         .max = 3600,
         .ours = true,
         .live = true}),
};

}  // namespace

extern constinit const ActingModuleKind dynamic_map_router_kind{
    .descriptor = {.component_class = ComponentClass::Acting,
                   .name = "DynamicMapRouter",
                   .paper_name = "AmDmr",
                   .summary = {"Maps the ground while driving over it, and routes the robot to a requested cell",
                               "Mapea el terreno mientras lo recorre y lleva el robot a la celda solicitada"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .rests_on = kRestsOn,
                   .source = "A growing functional modules locomotion subsystem, Methodology 1 and Algorithm 2"},
    .make = make_bound<ActingModule, DynamicMapRouter, DynamicMapRouterConfig>,
    .encode = grid::RiskMap::encode};

}  // namespace ganglion
