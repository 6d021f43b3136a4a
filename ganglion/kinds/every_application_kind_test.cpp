#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ganglion/kinds/applications.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/module/testing/allocations.h"

// What holds for every kind of plant and task there is: a new one is covered at birth.
namespace ganglion {
namespace {

constexpr std::string_view kWorld =
    "format = 1\nname = \"w\"\n[[wall]]\npoints = [[0, 0], [6, 0], [6, 6], [0, 6]]\nclosed = true\n";

/// An application with its frames; robots stand in a room.
class Ridden {
 public:
  Ridden(const std::string& file, int robots) {
    Problems problems;
    const auto root = config::parse(file, "file.toml");
    const config::Value none(config::Members(), Place{"experiment.toml", 1, 1});
    config::Table setting(none, "", problems);
    DiskFiles files;
    const bool robot = root->find("kind") == nullptr;
    const int world = robot ? files.hold("world", "world.toml", std::string(kWorld)) : -1;
    const auto model = read_application(
        {.file = *root, .files = &files, .setting = &setting, .world = world, .robots = robots}, problems);
    EXPECT_TRUE(model) << problems.text() << file;
    auto made = model->make();
    EXPECT_TRUE(made) << made.error().text();
    application_ = std::move(*made);
    const auto ready = application_->reset(1, 0);
    EXPECT_TRUE(ready) << ready.error().text();
    senses_.assign(static_cast<std::size_t>(robots), make_sense_frame(application_->description()));
    acts_.assign(static_cast<std::size_t>(robots), make_act_frame(application_->description()));
    for (ActFrame& act : acts_) std::fill(act.ttl_s.begin(), act.ttl_s.end(), 1e9);
  }
  /// Every command at that share of its range.
  void step(double share) {
    for (ActFrame& act : acts_) {
      std::size_t value = 0;
      for (const CommandChannel& channel : application_->description().commands) {
        for (const CommandElement& one : channel.elements) {
          act.values[value++] = one.min + (one.max - one.min) * share;
        }
      }
    }
    application_->step(acts_, 0.1);
    application_->sense(senses_);
  }
  const Application& application() const { return *application_; }
  const std::vector<SenseFrame>& senses() const { return senses_; }

 private:
  std::unique_ptr<Application> application_;
  std::vector<SenseFrame> senses_;
  std::vector<ActFrame> acts_;
};

std::vector<const Descriptor*> plants_and_tasks() {
  std::vector<const Descriptor*> all;
  for (const PlantKind* kind : plant_kinds()) all.push_back(&kind->descriptor);
  for (const TaskKind* kind : task_kinds()) all.push_back(&kind->descriptor);
  return all;
}

/// A test for each kind there is, named after it. A plant stands by itself; a task is set to three robots in a room.
class OfApplications : public ::testing::TestWithParam<const Descriptor*> {
 protected:
  static std::string file() {
    const Descriptor& kind = *GetParam();
    if (kind.component_class == ComponentClass::Plant) {
      return fmt::format("format = 1\nname = \"p\"\nkind = \"{}\"\n", kind.name);
    }
    return fmt::format(
        "format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\n[drive]\nkind = \"{}\"\n[[task]]\nid = "
        "\"t\"\nkind = \"{}\"\n",
        sim_kinds().drives.front()->descriptor.name, kind.name);
  }
};

TEST_P(OfApplications, StepsWithoutTakingMemoryAndStaysFinite) {
  Ridden ridden(file(), 3);
  const std::uint64_t before = testing::allocations();
  for (int n = 0; n < 200; ++n) {
    ridden.step(n % 7 / 6.0);
    ASSERT_EQ(testing::allocations(), before) << "allocates in step " << n;
  }
  for (int robot = 0; robot < 3; ++robot) {
    for (const double value : ridden.application().witness()->truth_of(robot)) EXPECT_TRUE(std::isfinite(value));
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, OfApplications, ::testing::ValuesIn(plants_and_tasks()),
                         [](const auto& one) { return std::string(one.param->name); });

TEST(EveryKind, OfApplicationsHasPortsThatFitItsClass) {
  for (const PlantKind* kind : plant_kinds()) {
    EXPECT_EQ(kind->descriptor.component_class, ComponentClass::Plant) << kind->descriptor.name;
    for (const PortDescriptor& port : kind->descriptor.ports) {
      EXPECT_TRUE(port.role == PortRole::Output || port.role == PortRole::Command) << port.name;
    }
  }
  for (const TaskKind* kind : task_kinds()) {
    EXPECT_EQ(kind->descriptor.component_class, ComponentClass::Task) << kind->descriptor.name;
    for (const PortDescriptor& port : kind->descriptor.ports) EXPECT_EQ(port.role, PortRole::Output) << port.name;
  }
}

}  // namespace
}  // namespace ganglion
