// Scenario SB12 in Enki (Debian package libenki-dev), for comparison: a program of its own that links nothing of ours.
// Usage: rival_enki_sb12 SCENE STEPS; prints robot-steps per CPU second and the mean of the first scan, capped at 3 m.
// Enki works in centimetres, and each of its infrared sensors casts three rays; the middle one is looked at.
#include <enki/PhysicalEngine.h>
#include <enki/interactions/IRSensor.h>
#include <enki/robots/DifferentialWheeled.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr int kSensors = 12;
constexpr double kPi = 3.14159265358979323846;
constexpr double kRange_cm = 300, kStep_s = 0.1;

class Avoider : public Enki::DifferentialWheeled {
 public:
  Avoider() : Enki::DifferentialWheeled(26, 100, 0) {
    setCylindric(15, 20, 1000);
    for (int k = 0; k < kSensors; ++k) {
      const double bearing = k * kPi / 6;
      const Enki::Vector rim(15 * std::cos(bearing), 15 * std::sin(bearing));
      sensors_[k] = std::make_unique<Enki::IRSensor>(this, rim, 5, bearing, kRange_cm, 3731, 0.3, 7, 0);
      addLocalInteraction(sensors_[k].get());
    }
  }
  double range_cm(int k) const { return std::min(sensors_[k]->getRayDist(1), kRange_cm); }
  void controlStep(double step_s) override {
    const double front_cm = std::min({range_cm(0), range_cm(1), range_cm(11)});
    if (turning_ == 0 && front_cm < 50) {
      turning_ = range_cm(2) > range_cm(10) ? 1 : -1;
    } else if (turning_ != 0 && front_cm > 70) {
      turning_ = 0;
    }
    leftSpeed = turning_ == 0 ? 30 : -20 * turning_;
    rightSpeed = turning_ == 0 ? 30 : 20 * turning_;
    Enki::DifferentialWheeled::controlStep(step_s);
  }

 private:
  std::array<std::unique_ptr<Enki::IRSensor>, kSensors> sensors_;
  int turning_ = 0;
};

/// Reads the scene into a world; Enki's world takes what is added to it for its own.
std::unique_ptr<Enki::World> read_scene(const char* path, std::vector<Avoider*>& robots) {
  std::ifstream file(path);
  std::string word;
  double side = 0, x = 0, y = 0, length = 0, width = 0, yaw = 0;
  if (!(file >> word >> side) || word != "arena") return nullptr;
  auto world = std::make_unique<Enki::World>(side * 100, side * 100);
  while (file >> word) {
    Enki::PhysicalObject* object = nullptr;
    if (word == "box" && file >> x >> y >> length >> width >> yaw) {
      object = new Enki::PhysicalObject;
      object->setRectangular(length * 100, width * 100, 20, -1);
    } else if (word == "robot" && file >> x >> y >> yaw) {
      robots.push_back(new Avoider);
      object = robots.back();
    } else {
      return nullptr;
    }
    object->pos = Enki::Point(x * 100, y * 100);
    object->angle = yaw;
    world->addObject(object);
  }
  return world;
}

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double mean_range_m(const std::vector<Avoider*>& robots) {
  double sum_cm = 0;
  for (const Avoider* robot : robots) {
    for (int k = 0; k < kSensors; ++k) sum_cm += robot->range_cm(k);
  }
  return sum_cm / (100.0 * kSensors * static_cast<double>(robots.size()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::vector<Avoider*> robots;
  const auto world = read_scene(argv[1], robots);
  const int steps = std::stoi(argv[2]);
  if (world == nullptr || robots.empty() || steps < 1) return 2;
  world->step(1e-6);  // a scan from where the robots start, give or take 0.3 um
  const double first_scan_m = mean_range_m(robots);
  for (int n = 0; n < 20; ++n) world->step(kStep_s);
  const double began_s = cpu_s();
  for (int n = 0; n < steps; ++n) world->step(kStep_s);
  std::cout << static_cast<double>(robots.size()) * steps / (cpu_s() - began_s) << ' ' << first_scan_m << '\n';
}
