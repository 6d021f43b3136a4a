#include "ganglion/task/tasked_application.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {

extern const TaskKind hold_kind;

namespace {

constexpr std::array kKinds = {&hold_kind};

/// Counts its steps, which is the only thing that is true of it.
class Counter final : public Application, public Witness {
 public:
  explicit Counter(bool known) : known_(known) {
    description_.name = "counter";
    description_.sensations = {{.name = "count"}};
    description_.commands = {{"go", {{"go", ""}}}};
  }
  const Description& description() const noexcept override { return description_; }
  int robots() const noexcept override { return 2; }
  Result<void> reset(std::uint64_t, std::uint32_t) override {
    steps_ = 0;
    return {};
  }
  void sense(std::span<SenseFrame> frames) noexcept override {
    for (SenseFrame& frame : frames) frame.values[0] = steps_, frame.ages_s[0] = 0.5;
  }
  void step(std::span<const ActFrame>, double) noexcept override { ++steps_; }
  const Witness* witness() const noexcept override { return known_ ? this : nullptr; }
  std::span<const TruthChannel> truth_channels() const noexcept override { return channels_; }
  std::span<const double> truth_of(int) const noexcept override { return {&steps_, 1}; }
  double time_s() const noexcept override { return steps_; }

 private:
  bool known_;
  Description description_;
  std::vector<TruthChannel> channels_ = {{.name = "steps", .unit = "", .title = {}}};
  double steps_ = 0;
};

struct Read {
  Description description = Counter(true).description();
  std::vector<TaskModel> tasks;
  Problems problems;
};
Read read(const std::string& text) {
  Read result;
  const auto root = config::parse(text, "robot.toml");
  EXPECT_TRUE(root);
  config::Table table(*root, "", result.problems);
  std::vector<std::string> ids = {"count"};
  result.tasks = read_tasks(table, kKinds, ids, result.description);
  return result;
}

const std::string kTwo =
    "[[task]]\nid = \"one\"\nkind = \"Hold\"\nvalues = [4, 7]\neach_s = 2\n[[task]]\nid = \"two\"\nkind = "
    "\"Hold\"\nvalues = [9]\n";

TEST(TaskedApplication, PutsTheChannelsOfItsTasksBehindItsOwn) {
  Read file = read(kTwo);
  ASSERT_EQ(file.problems.text(), "");
  auto made = TaskedApplication::make(std::make_unique<Counter>(true), file.description, file.tasks);
  ASSERT_TRUE(made) << made.error().what.en;
  Application& tasked = **made;
  ASSERT_TRUE(tasked.reset(1, 0));
  std::vector<SenseFrame> sense(2, make_sense_frame(tasked.description()));
  std::vector<ActFrame> act(2, make_act_frame(tasked.description()));
  tasked.sense(sense);
  EXPECT_EQ(sense[0].values, (std::vector<double>{0, 4, 2, 9, std::numeric_limits<double>::infinity()}));
  EXPECT_EQ(sense[1].ages_s, (std::vector<double>{0.5, 0, 0, 0, 0}));
  tasked.step(act, 1);
  tasked.step(act, 1);
  EXPECT_EQ(tasked.witness()->ledger(1, "one")->rows(), 2u) << "judged at the end of the step, before anybody senses";
  tasked.sense(sense);
  EXPECT_EQ(sense[1].values[1], 7);
  EXPECT_EQ(tasked.witness()->ledger(0, "three"), nullptr);
  ASSERT_EQ(tasked.witness()->ledgers().size(), 2u);
  EXPECT_EQ(tasked.witness()->ledgers()[1].task, "two");
}

TEST(TaskedApplication, NeedsToKnowTheTruthButNotWithoutATask) {
  const Read file = read(kTwo);
  const auto made = TaskedApplication::make(std::make_unique<Counter>(false), file.description, file.tasks);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().what.en, "\"counter\" is set a task, but nobody there knows what is true of it");
  EXPECT_TRUE(TaskedApplication::make(std::make_unique<Counter>(false), file.description, {}));
}

/// A task that begins where it is willing to.
class Moody final : public Task {
 public:
  Result<void> begin(const Outlook&, Draws) override {
    if (willing) return {};
    return fail(ErrorCode::BadParameter, {"not now", "ahora no"});
  }
  void judge(const Outlook&) noexcept override { ++judged; }
  void tell(const Outlook&, std::span<double> values) const noexcept override { values[0] = 1; }
  static inline bool willing = true;
  static inline int judged = 0;
};
constexpr std::array kMood = {
    PortDescriptor{.name = "mood", .title = {"mood", "ánimo"}, .help = {"1", "1"}, .role = PortRole::Output}};
constexpr TaskKind kMoody{
    .descriptor = {.component_class = ComponentClass::Task, .name = "Moody", .ports = kMood},
    .make = [](const Parameters&) -> Result<std::unique_ptr<Task>> { return std::make_unique<Moody>(); }};

TEST(TaskedApplication, AsksATaskNothingAfterAResetThatFailed) {
  Description description = Counter(true).description();
  description.sensations.push_back({.name = "a.mood"});
  std::vector<TaskModel> tasks(1);
  tasks[0].id = "a";
  tasks[0].kind = &kMoody;
  auto made = TaskedApplication::make(std::make_unique<Counter>(true), description, tasks);
  ASSERT_TRUE((*made)->reset(1, 0));
  std::vector<SenseFrame> sense(2, make_sense_frame((*made)->description()));
  std::vector<ActFrame> act(2, make_act_frame((*made)->description()));
  (*made)->sense(sense);
  EXPECT_EQ(sense[0].values[1], 1);
  Moody::willing = false;
  ASSERT_FALSE((*made)->reset(1, 1));
  const int judged = Moody::judged;
  (*made)->step(act, 1);
  (*made)->sense(sense);
  EXPECT_EQ(Moody::judged, judged);
  EXPECT_TRUE(std::isnan(sense[0].values[1]));
  EXPECT_EQ((*made)->intervene({"goal", 0, "", {}}).error().what.en, "the tasks have not begun: reset first");
  Moody::willing = true;
  ASSERT_TRUE((*made)->reset(1, 2));
}

TEST(TaskedApplication, RefusesInterventionsThatNobodyTakes) {
  const Read file = read(kTwo);
  auto made = TaskedApplication::make(std::make_unique<Counter>(true), file.description, file.tasks);
  ASSERT_TRUE((*made)->reset(1, 0));
  EXPECT_EQ((*made)->intervene({"goal", 0, "", {}}).error().code, ErrorCode::Unsupported);
  EXPECT_EQ((*made)->intervene({"goal", 2, "", {}}).error().what.en,
            "there is no robot 2: they are numbered from 0 to 1");
}

TEST(Tasks, AreRefusedWithTheirPlace) {
  EXPECT_EQ(read("[[task]]\nid = \"count\"\nkind = \"Hold\"\n").problems.text(),
            "robot.toml:2:6: count: id \"count\" is given twice\n");
  EXPECT_NE(read("[[task]]\nid = \"a\"\nkind = \"Hodl\"\n").problems.text().find("did you mean \"Hold\"?"),
            std::string::npos);
  EXPECT_NE(read("[[task]]\nid = \"a\"\nkind = \"Hold\"\neach_s = -3\n").problems.text().find("robot.toml:4:10: a: "),
            std::string::npos);
}

}  // namespace
}  // namespace ganglion
