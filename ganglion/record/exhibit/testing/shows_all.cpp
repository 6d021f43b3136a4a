#include "ganglion/record/exhibit/testing/shows_all.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace ganglion {
namespace {

constexpr std::array<Class, 3> kGrounds = {{{0, Role::Free, {"open ground", "suelo libre"}},
                                            {1, Role::Solid, {"a rock", "una roca"}},
                                            {2, Role::Danger, {"a pit", "un foso"}}}};

/// Columns x rows values of which the first is unknown.
std::vector<float> values_of(int columns, int rows, float (*value)(int, int)) {
  std::vector<float> values;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) values.push_back(value(column, row));
  }
  values.front() = std::numeric_limits<float>::quiet_NaN();
  return values;
}

}  // namespace

void ShowsAll::show_fields(Exhibition& to) const {
  static const auto kWarmth = values_of(8, 6, [](int c, int r) { return static_cast<float>(10 + 2 * c + r); });
  static const auto kGround = values_of(8, 6, [](int c, int r) {
    return static_cast<float>(c == 5 && r < 4 ? 1 : c == 2 && r == 3 ? 2 : 0);
  });
  std::vector<float> visits = values_of(8, 6, [](int c, int r) { return static_cast<float>((c * r) % 5); });
  visits[20] = static_cast<float>(stage);
  const std::array<Layer, 3> layers = {
      {{.name = "warmth",
        .title = {"Warmth", "Calor"},
        .unit = "degC",
        .scale = {.low = 10, .high = 30},
        .values = kWarmth},
       {.name = "visits", .title = {"Visits", "Visitas"}, .scale = {.low = 0, .high = 4}, .values = visits},
       {.name = "ground",
        .title = {"Ground", "Suelo"},
        .scale = {.low = 0, .high = 2, .classes = kGrounds},
        .values = kGround}}};
  to.field({.name = "meadow",
            .title = {"Meadow", "Prado"},
            .origin = {0.5, 0.5},
            .cell = {0.5, 0.5},
            .columns = 8,
            .rows = 6,
            .layers = layers});
  static constexpr std::array<Text, 3> kNear = {Text("near", "cerca"), Text("fit", "bien"), Text("far", "lejos")};
  static constexpr std::array<Text, 2> kError = {Text("left", "izquierda"), Text("right", "derecha")};
  static const auto kStrength = values_of(3, 2, [](int c, int r) { return static_cast<float>(0.3 * c + 0.2 * r); });
  const std::array<Layer, 3> rules = {
      {{.name = "firing", .title = {"Firing", "Activación"}, .values = kStrength},
       {.name = "weight", .title = {"Weight", "Peso"}, .values = kStrength},
       {.name = "learned", .title = {"Learned", "Aprendido"}, .unit = "J", .values = kStrength}}};
  to.field({.name = "rules",
            .title = {"Rules", "Reglas"},
            .frame = "",
            .columns = 3,
            .rows = 2,
            .across = Axis{.title = {"Distance", "Distancia"}, .unit = "m", .ticks = kNear},
            .up = Axis{.title = {"Side", "Lado"}, .ticks = kError},
            .layers = rules});
}

void ShowsAll::show_marks(Exhibition& to) const {
  static constexpr std::array<Vector2, 3> kWay = {{{0.5, 0.5}, {2, 1}, {3.5, 3}}};
  static constexpr std::array<Vector2, 4> kField = {{{1, 2}, {2, 2}, {2, 3}, {1, 3}}};
  static constexpr std::array<Vector2, 1> kGoal = {{{3.5, 3}}};
  static constexpr std::array<Vector2, 1> kHome = {{{0.5, 0.5}}};
  static constexpr std::array<Vector2, 1> kNose = {{{0.1, 0}}};
  static constexpr std::array<Vector2, 2> kMast = {{{0, 0}, {0.6, 0}}};
  const std::array<Shape, 7> shapes = {
      {{.role = Role::Plan, .points = kWay},
       {.form = Form::Polygon, .role = Role::Place, .points = kField, .label = {"the yard", "el patio"}},
       {.form = Form::Disc,
        .role = stage > 1 ? Role::Reached : Role::Goal,
        .id = "goal 1",
        .points = kGoal,
        .radius_m = 0.2,
        .label = {"1", "1"}},
       {.form = Form::Point, .role = Role::Reference, .points = kHome},
       {.form = Form::Label, .role = Role::Plain, .points = kHome, .label = {"home", "casa"}},
       {.form = Form::Sector, .role = Role::Echo, .frame = "nose", .points = kNose, .radius_m = 0.8, .angle_rad = 0.6},
       {.role = Role::Self, .frame = "mast", .points = kMast}}};
  to.frame({.name = "nose", .x_m = "truth.x_m", .y_m = "truth.y_m", .yaw_rad = "truth.yaw_rad"});
  to.frame({.name = "mast", .in = "nose", .fixed = {{-0.1, 0}, Angle::from_deg(90)}});
  to.marks({.name = "marks", .title = {"Marks", "Marcas"}, .shapes = shapes});
}

void ShowsAll::show(Exhibition& to) const {
  show_fields(to);
  show_marks(to);
  static constexpr std::array<double, 3> kX = {0, 1, 2}, kUp = {0, 1, 0}, kDown = {1, 0.25, 0};
  const std::array<Line, 2> lines = {{{.title = {"near", "cerca"}, .role = Role::Measured, .x = kX, .y = kDown},
                                      {.title = {"fit", "bien"}, .role = Role::Reference, .x = kX, .y = kUp}}};
  to.curve({.name = "terms",
            .title = {"Sets of the distance", "Conjuntos de la distancia"},
            .across = {.title = {"Distance", "Distancia"}, .unit = "m"},
            .up = {.title = {"Degree", "Grado"}},
            .lines = lines,
            .cursor = "truth.x_m"});
  const std::array<Bar, 3> bars = {
      {{.title = {"rule 1", "regla 1"}, .value = 0.2 + 0.1 * stage, .role = Role::Measured},
       {.title = {"rule 2", "regla 2"}, .value = 0.9, .role = Role::Measured},
       {.title = {"rule 3", "regla 3"}, .value = -0.4, .role = Role::Danger}}};
  to.bars({.name = "firing",
           .title = {"Firing strength", "Activación"},
           .up = {.title = {"Strength", "Fuerza"}},
           .bars = bars});
  static constexpr std::array<Node, 3> kNodes = {
      {{.title = {"hungry", "hambre"}, .place = {0, 0}, .value = 1, .role = Role::Self},
       {.title = {"fed", "saciado"}, .place = {2, 1}, .role = Role::Goal},
       {.title = {"tired", "cansado"}, .place = {2, -1}}}};
  static constexpr std::array<Edge, 3> kEdges = {{{0, 1, 1, Role::Plan}, {1, 2, 0.5}, {2, 0, 0.25}}};
  to.network({.name = "causes", .title = {"Causes", "Causas"}, .nodes = kNodes, .edges = kEdges});
}

void KeepsShown::add(std::string_view name, std::optional<shown::Exhibit> exhibit) {
  if (!exhibit) return;
  const std::string topic = exhibit_topic(owner_, form_name(*exhibit), name);
  const auto same = [&](const ExhibitTrack& track) {
    return exhibit_topic(track.owner, track.form, track.name) == topic;
  };
  auto track = std::find_if(tracks.begin(), tracks.end(), same);
  if (track == tracks.end()) track = tracks.insert(tracks.end(), *track_of(topic));
  track->add(time_s, std::move(*exhibit));
}

}  // namespace ganglion
