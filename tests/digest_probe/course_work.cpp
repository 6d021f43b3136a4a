#include <algorithm>
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
  Course(const Prepared& prepared, std::unique_ptr<Application> application)
      : step_s_(prepared.step_s), application_(std::move(application)) {
    const Description& description = prepared.application->description();
    sense_.assign(static_cast<std::size_t>(application_->robots()), make_sense_frame(description));
    act_.assign(sense_.size(), make_act_frame(description));
    for (const char* name : {"x_m", "y_m", "yaw_rad", "energy_J", "fastest_contact_mps", "value"}) {
      if (const auto index = index_of(prepared.application->truth(), name)) probed_.push_back(*index);
    }
  }

  Result<void> add_controllers(const Prepared& prepared) {
    for (std::uint32_t robot = 0; robot < sense_.size(); ++robot) {
      auto made = Controller::compile(prepared.controller, prepared.application->description(), controller_kinds(),
                                      {.seed = kSeed, .robot = robot});
      if (!made) return tl::unexpected(made.error());
      controllers_.push_back(std::move(*made));
      truth_.join(robot, "@truth");
    }
    return {};
  }

  void drive() {
    for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
      application_->sense(sense_);
      for (std::size_t i = 0; i < controllers_.size(); ++i) {
        controllers_[i].tick(sense_[i], step_s_, act_[i]);
        const auto truth = application_->witness()->truth_of(static_cast<int>(i));
        std::vector<double> values;
        for (const std::size_t index : probed_) values.push_back(truth[index]);
        truth_.add(i, tick, values);
      }
      application_->step(act_, step_s_);
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
  std::unique_ptr<Application> application_;
  std::vector<std::size_t> probed_;  // channels of the truth
  std::vector<Controller> controllers_;
  std::vector<SenseFrame> sense_;
  std::vector<ActFrame> act_;
  Digest truth_;
};

Result<void> drive(const Prepared& prepared, const std::string& name) {
  auto application = prepared.application->make();
  if (!application) return tl::unexpected(application.error());
  if (auto reset = (*application)->reset(kSeed, 0); !reset) return tl::unexpected(reset.error());
  Course course(prepared, std::move(*application));
  if (auto added = course.add_controllers(prepared); !added) return added;
  course.drive();
  course.tell_all(name);
  return {};
}

bool probe_controller(const fs::path& experiment, const fs::path& controller) {
  const std::string name = (experiment.filename() / controller.filename()).generic_string();
  for (const char* robots : {"1", "4"}) {
    Problems problems;
    const auto prepared =
        prepare(experiment, {{"application.robots", robots}}, problems, {.experiment = {}, .controller = controller});
    if (!prepared) {
      std::fprintf(stderr, "%s\n", problems.text().c_str());
      return false;
    }
    const std::string which = fmt::format("{} x{}", name, robots);
    if (auto driven = drive(*prepared, which); !driven) {
      if (prepared->experiment.robots == 1) {
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
