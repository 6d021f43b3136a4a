// Robot-steps per CPU second in scenario SB12 (support/sb12.h), beside Enki's where its program could be built.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "bench/support/rows.h"
#include "bench/support/sb12.h"

namespace {

using namespace ganglion;
using namespace ganglion::bench;

constexpr int kWarmUp = 20;
constexpr int kRivalRays = 36;  // Enki's sensor always casts three

/// Steps measured: 200, and more of them where few robots would make too short a measurement.
int steps_for(int robots) { return std::max(200, 20'000 / robots); }

sim::SimulationConfig config_of(const Sb12Scene& scene, Eyes eyes) {
  return {sb12_ground(scene), sb12_robot(eyes), static_cast<int>(scene.robots.size()), sim::SpawnPoses{scene.robots}};
}

double robot_steps_per_s(const Sb12Scene& scene, Eyes eyes) {
  Sb12Run run(config_of(scene, eyes));
  run.reset(1, 0);
  for (int n = 0; n < kWarmUp; ++n) run.step();
  const int robots = run.simulation().robots(), steps = steps_for(robots);
  const double began_s = cpu_s();
  for (int n = 0; n < steps; ++n) run.step();
  return robots * steps / (cpu_s() - began_s);
}

double first_scan_m(const Sb12Scene& scene) {
  Sb12Run run(config_of(scene, Eyes::IdealRays));
  run.reset(1, 0);
  const int robots = run.simulation().robots();
  double sum_m = 0;
  for (int i = 0; i < robots; ++i) {
    for (int k = 0; k < 12; ++k) sum_m += run.range_m(i, k, 3);
  }
  return sum_m / (12 * robots);
}

/// What Enki's program says of a scene: robot-steps per second, and the mean of its first scan [m].
struct Rival {
  double robot_steps_per_s = 0;
  double first_scan_m = 0;
};
std::optional<Rival> enki(const std::string& program, const std::filesystem::path& scene, int steps) {
  if (!std::filesystem::exists(program)) return std::nullopt;
  const std::string command = program + " " + scene.string() + " " + std::to_string(steps);
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  Rival rival;
  const bool read = std::fscanf(pipe, "%lf %lf", &rival.robot_steps_per_s, &rival.first_scan_m) == 2;
  return pclose(pipe) == 0 && read ? std::optional(rival) : std::nullopt;
}

void measure(int robots, const std::string& rival_program, std::vector<Row>& rows) {
  const Sb12Scene scene = sb12_scene(robots);
  const auto file = std::filesystem::temp_directory_path() / ("sb12_" + std::to_string(getpid()) + ".txt");
  std::ofstream(file) << sb12_text(scene);
  const std::string name = "sb12/" + std::to_string(robots);
  std::optional<Rival> last;
  rows.push_back(measured(
      name, "robot-steps/s", [&] { return robot_steps_per_s(scene, Eyes::IdealRays); },
      [&]() -> std::optional<double> {
        last = enki(rival_program, file, steps_for(robots));
        return last ? std::optional(last->robot_steps_per_s) : std::nullopt;
      }));
  Row rays{name + "/rays", 12 * rows.back().ours, std::nullopt, "rays/s"};
  if (rows.back().rival) rays.rival = kRivalRays * *rows.back().rival;
  rows.push_back(std::move(rays));
  rows.push_back(
      {name + "/first_scan", first_scan_m(scene), last ? std::optional(last->first_scan_m) : std::nullopt, "m"});
  std::filesystem::remove(file);
}

void measure_sonar(int robots, std::vector<Row>& rows) {
  const Sb12Scene scene = sb12_scene(robots);
  for (const auto& [eyes, reach] : {std::pair(Eyes::Sonar3m, "3m"), std::pair(Eyes::Sonar6m, "6m")}) {
    rows.push_back(measured("sb12/" + std::to_string(robots) + "/sonar_" + reach, "robot-steps/s",
                            [&] { return robot_steps_per_s(scene, eyes); }));
  }
}

constexpr const char* kRemarks =
    "Robot-steps per CPU second, one thread, medians of three runs taken in turn with the rival's. The rival is Enki,\n"
    "whose sensors cast three rays each where ours cast one. sonar: 12 x 5 rays and one mirror bounce on smooth "
    "walls,\n"
    "noise, encoders and compass, every step. Not modelled by us: mass, inertia and friction of bodies; robots push\n"
    "each other slowly, by the slip of their wheels. first_scan: mean of all sensors before the first step, capped at "
    "3 m.\n";

}  // namespace

int main(int argc, char** argv) {
  const std::string rival = (std::filesystem::path(argv[0]).parent_path() / "rival_enki_sb12").string();
  std::vector<Row> rows;
  for (const int robots : {1, 10, 100, 1000}) measure(robots, rival, rows);
  for (const int robots : {100, 1000}) measure_sonar(robots, rows);
  return print(rows, argc, argv, kRemarks);
}
