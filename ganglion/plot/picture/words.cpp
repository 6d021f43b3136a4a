#include "ganglion/plot/picture/words.h"

namespace ganglion::plot {
namespace {

constexpr Words kEnglish{
    .trajectory = "Trajectory",
    .trajectory_about = "The way each robot drove, seen from above.",
    .signals = "Signals over time",
    .signals_about = "Every recorded signal against time.",
    .behaviours = "Behaviours over time",
    .behaviours_about = "Which behaviour drove, and which wanted to but was suppressed.",
    .legend = "Legend",
    .start = "start",
    .end = "end",
    .path = "trajectory",
    .contact = "contact",
    .wall = "wall",
    .static_obstacle = "static obstacle",
    .dynamic_obstacle = "dynamic obstacle",
    .earlier_place = "its other places",
    .unknown_ground = "unknown ground",
    .floor_zone = "other floor",
    .bump = "bump, unseen by sonar",
    .beacon = "beacon",
    .true_outline = "true walls, obstacles",
    .no_behaviour = "no behaviour",
    .active = "drives",
    .suppressed = "wants to, suppressed",
    .quiet = "quiet",
    .time = "time",
    .unexplored = "unknown",
    .no_reading = "no valid reading",
    .nothing_in_range = "nothing in range",
    .too_close = "too close",
    .no_data = "nothing was recorded",
    .robot = "robot",
};

constexpr Words kSpanish{
    .trajectory = "Trayectoria",
    .trajectory_about = "El camino de cada robot, visto desde arriba.",
    .signals = "Señales en el tiempo",
    .signals_about = "Cada señal registrada frente al tiempo.",
    .behaviours = "Comportamientos en el tiempo",
    .behaviours_about = "Qué comportamiento conducía y cuál quería hacerlo pero estaba suprimido.",
    .legend = "Leyenda",
    .start = "inicio",
    .end = "final",
    .path = "trayectoria",
    .contact = "contacto",
    .wall = "pared",
    .static_obstacle = "obstáculo estático",
    .dynamic_obstacle = "obstáculo dinámico",
    .earlier_place = "sus otros lugares",
    .unknown_ground = "suelo desconocido",
    .floor_zone = "otro suelo",
    .bump = "resalto, el sonar no lo ve",
    .beacon = "baliza",
    .true_outline = "paredes, obstáculos",
    .no_behaviour = "ningún comportamiento",
    .active = "conduce",
    .suppressed = "quiere, suprimido",
    .quiet = "en reposo",
    .time = "tiempo",
    .unexplored = "desconocido",
    .no_reading = "sin lectura válida",
    .nothing_in_range = "nada al alcance",
    .too_close = "demasiado cerca",
    .no_data = "no se registró nada",
    .robot = "robot",
};

}  // namespace

const Words& words(Language language) noexcept { return language == Language::Spanish ? kSpanish : kEnglish; }

}  // namespace ganglion::plot
