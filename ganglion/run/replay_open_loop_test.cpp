#include "ganglion/run/replay_open_loop.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"

// A log of 6 s at ten rows a second, in which an obstacle is 0.09 m off from 1.0 to 1.5 s; its times are written in ways
// that logs of other programs have.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

class OpenLoop : public FolderTest {
 protected:
  struct Answer {
    std::string table, problems, notes;
  };

  Answer replay(const std::function<std::string(int row)>& time_of) const {
    std::string csv = "time_s,sonar_left,sonar_right,heading\n";
    for (int row = 0; row < 60; ++row) {
      const double range_m = row >= 10 && row < 15 ? 0.09 : 1.5;
      csv += fmt::format("{},{},{},0.3\n", time_of(row), range_m, range_m);
    }
    EXPECT_TRUE(write_file(folder_ / "log.csv", csv));
    Problems problems;
    const fs::path nimrod = fs::path(GANGLION_SOURCE_DIR) / "experiments" / "nimrod";
    const auto table = replay_open_loop(nimrod / "controller.toml", folder_ / "log.csv", problems);
    Answer answer{table ? *table : "", problems.text(), ""};
    for (const Problems::Note& note : problems.notes()) answer.notes += note.text().en;
    return answer;
  }

  static std::size_t escapes(const std::string& table) {
    std::size_t count = 0;
    for (std::size_t at = table.find(",escape\n"); at != std::string::npos; at = table.find(",escape\n", at + 1))
      ++count;
    return count;
  }
};

TEST_F(OpenLoop, TakesSecondsFromAnyBeginning) {
  const Answer plain = replay([](int row) { return fmt::format("{:.3f}", row * 0.1); });
  EXPECT_EQ(plain.problems + plain.notes, "");
  EXPECT_GT(escapes(plain.table), 5u);
  const Answer epoch = replay([](int row) { return fmt::format("{:.3f}", 1732340000 + row * 0.1); });
  EXPECT_EQ(epoch.problems + epoch.notes, "");
  EXPECT_EQ(escapes(epoch.table), escapes(plain.table));
}

TEST_F(OpenLoop, RefusesTimesThatStandAtTheirLine) {
  const Answer answer = replay([](int) { return "1.73234e+09"; });
  EXPECT_NE(answer.problems.find("log.csv:3:1: time_s is 1732340000, must be after 1732340000"), std::string::npos)
      << answer.problems;
}

TEST_F(OpenLoop, RefusesTimesThatGoBackAtTheirLine) {
  const Answer answer = replay([](int row) { return fmt::format("{:.1f}", (row < 30 ? row : row - 20) * 0.1); });
  EXPECT_NE(answer.problems.find("log.csv:32:1: time_s is 1, must be after 2.9"), std::string::npos) << answer.problems;
}

TEST_F(OpenLoop, RefusesTimesThatAreNoNumber) {
  const Answer answer = replay([](int row) { return row == 5 ? std::string("nan") : fmt::to_string(row); });
  EXPECT_NE(answer.problems.find("log.csv:7:1: time_s is nan"), std::string::npos) << answer.problems;
  EXPECT_NE(replay([](int row) { return row == 59 ? std::string("inf") : fmt::to_string(row); }).problems, "");
}

TEST_F(OpenLoop, AsksWhetherStepsFarOffAreInAnotherUnit) {
  const auto asked = [this](double factor) {
    return replay([factor](int row) { return fmt::format("{:.0f}", row * 0.1 * factor); }).notes;
  };
  EXPECT_NE(asked(1e3).find("log.csv:2:1: note: the steps of time_s are about 100 s, the controller's own is 0.1 s: "
                            "are these milliseconds?"),
            std::string::npos)
      << asked(1e3);
  EXPECT_NE(asked(1e6).find("microseconds?"), std::string::npos);
  EXPECT_NE(asked(1e9).find("nanoseconds?"), std::string::npos);
  const std::string fine = replay([](int row) { return fmt::format("{:.4f}", row * 0.005); }).notes;
  EXPECT_NE(fine.find("about 0.005 s"), std::string::npos) << fine;
}

}  // namespace
}  // namespace ganglion
