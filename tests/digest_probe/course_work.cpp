#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "ganglion/base/hash.h"
#include "ganglion/graph/controller.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/prepared.h"
#include "tests/digest_probe/work.h"

namespace ganglion::probe {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kTicks = 600;
constexpr std::uint64_t kSeed = 3;

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// What every robot sensed, did and was, component by component, and what it has learned.
class Course {
 public:
  Course(const Prepared& prepared, std::unique_ptr<sim::Simulation> simulation)
      : step_s_(prepared.step_s), simulation_(std::move(simulation)) {
    const RobotDescription& description = prepared.robot->description;
    sense_.assign(static_cast<std::size_t>(simulation_->robots()), make_sense_frame(description));
    act_.assign(sense_.size(), make_act_frame(description));
  }

  Result<void> add_controllers(const Prepared& prepared) {
    for (std::uint32_t robot = 0; robot < sense_.size(); ++robot) {
      auto made = Controller::compile(prepared.controller, prepared.robot->description, controller_kinds(),
                                      {.seed = kSeed, .robot = robot});
      if (!made) return tl::unexpected(made.error());
      controllers_.push_back(std::move(*made));
      truth_.join(robot, "@truth");
    }
    return {};
  }

  void drive() {
    for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
      simulation_->sense(sense_);
      for (std::size_t i = 0; i < controllers_.size(); ++i) {
        controllers_[i].tick(sense_[i], step_s_, act_[i]);
        const sim::Truth& truth = simulation_->truth(static_cast<int>(i));
        truth_.add(i, tick,
                   std::array{truth.pose.position.x, truth.pose.position.y, truth.pose.yaw.rad(), truth.energy_J,
                              truth.fastest_contact_mps});
      }
      simulation_->step(act_, step_s_);
      for (Controller& controller : controllers_) controller.grow();
    }
  }

  void tell_all(const std::string& name) const {
    tell_each(name, truth_);
    for (std::size_t i = 0; i < controllers_.size(); ++i) {
      tell_each(name, controllers_[i].digest());
      for (const ModuleExperience& learned : controllers_[i].experience()) {
        std::uint64_t hash = 0;
        for (const ExperiencePart& part : learned.parts) {
          hash = combine(combine(hash, hash_name(part.name)), hash_bytes(part.bytes));
        }
        tell(fmt::format("{} robot{}/{} learned", name, i, learned.component), hash);
      }
    }
  }

 private:
  static void tell_each(const std::string& name, const Digest& digest) {
    for (const Digest::OfComponent& one : digest.components()) {
      tell(fmt::format("{} robot{}/{}", name, one.robot, one.component), one.value);
    }
  }

  double step_s_;
  std::unique_ptr<sim::Simulation> simulation_;
  std::vector<Controller> controllers_;
  std::vector<SenseFrame> sense_;
  std::vector<ActFrame> act_;
  Digest truth_;
};

Result<void> drive(Prepared prepared, int robots, const std::string& name) {
  prepared.experiment.robots = robots;
  auto simulation = sim::Simulation::make(prepared.simulation(prepared.ground, {}));
  if (!simulation) return tl::unexpected(simulation.error());
  if (auto reset = (*simulation)->reset(kSeed, 0); !reset) return tl::unexpected(reset.error());
  Course course(prepared, std::move(*simulation));
  if (auto added = course.add_controllers(prepared); !added) return added;
  course.drive();
  course.tell_all(name);
  return {};
}

bool probe_controller(const fs::path& experiment, const fs::path& controller) {
  Problems problems;
  const auto prepared = prepare(experiment, {}, problems, {.experiment = {}, .controller = controller});
  if (!prepared) {
    std::fprintf(stderr, "%s\n", problems.text().c_str());
    return false;
  }
  const std::string name = (experiment.filename() / controller.filename()).generic_string();
  for (const int robots : {1, 4}) {
    const std::string which = fmt::format("{} x{}", name, robots);
    if (auto driven = drive(*prepared, robots, which); !driven) {
      if (robots == 1) {
        std::fprintf(stderr, "%s: %s\n", which.c_str(), driven.error().text().c_str());
        return false;
      }
      std::printf("%s: not for several robots\n", which.c_str());  // it starts from one place
    }
  }
  return true;
}

}  // namespace

void tell(std::string_view what, std::uint64_t fingerprint) {
  std::printf("%s %.*s\n", hex(fingerprint).c_str(), static_cast<int>(what.size()), what.data());
}

bool probe_experiments(const fs::path& folder) {
  int probed = 0;
  for (const fs::path& experiment : files_of(folder)) {
    if (!fs::exists(experiment / "experiment.toml")) continue;
    for (const fs::path& file : files_of(experiment)) {
      if (!file.filename().string().starts_with("controller") || file.extension() != ".toml") continue;
      if (!probe_controller(experiment, file)) return false;
      ++probed;
    }
  }
  if (probed == 0) std::fprintf(stderr, "no experiments in %s\n", folder.c_str());
  return probed > 0;
}

}  // namespace ganglion::probe
