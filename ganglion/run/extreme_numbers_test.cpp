#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/run/check_file.h"
#include "ganglion/run/run.h"

// One number of a shipped file is exchanged for one that nobody would write. Either `check` refuses it with its place, or
// a run of it comes to the end of its first tick. GANGLION_EXTREME_NUMBERS says how many files are tried.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr std::array kExtremes = {"0",     "-1",     "1",          "1e-300",     "5e-324",     "1e-9",
                                  "1e-7",  "1e-6",   "1e-3",       "100",        "3600",       "1e6",
                                  "1e9",   "1e12",   "2147483647", "2147483648", "4294967295", "9223372036854775807",
                                  "1e300", "-1e300", "1.7e308",    "10000",      "-1e9",       "-9223372036854775808"};

/// Keys that few of the files have, where they would stand.
struct Key {
  std::string_view file, behind, line;
};
constexpr std::array kKeys = {
    Key{"experiment", "[run]\n", "maps_every_s = {}\n"},
    Key{"experiment", "[application]\n", "robots = {}\n"},
    Key{"experiment", "[run]\n", "free_ground = true\n"},
    Key{"controller", "format = 1\n", "tick_s = {}\n"},
    Key{"robot", "format = 1\n", "substep_s = {}\n"},
    Key{"robot", "[[sensor]]\n", "period_s = {}\n"},
    Key{"robot", "[[sensor]]\n", "phase_s = {}\n"},
    Key{"experiment", "format = 1\n",
        "fault = [{{ target = \"sonar_left\", kind = \"late\", amount = {0}, from_s = {0} }}]\n"}};

struct Span {
  std::size_t at, length;
};

/// Where numbers stand in a text, outside of comments, strings and keys.
std::vector<Span> numbers_in(const std::string& text) {
  std::vector<Span> spans;
  bool comment = false, quoted = false, value = false;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') comment = false, value = depth > 0;
    if (comment) continue;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '#') comment = true;
    if (c == '=') value = true;
    if (value && c == '[') ++depth;
    if (value && c == ']') --depth;
    const auto starts = [](char d) { return std::isdigit(static_cast<unsigned char>(d)) != 0 || d == '-' || d == '+'; };
    if (!value || !starts(c)) continue;
    std::size_t end = i + 1;
    const auto goes_on = [](char d) {
      return std::isalnum(static_cast<unsigned char>(d)) != 0 || d == '.' || d == '-';
    };
    while (end < text.size() && goes_on(text[end])) ++end;
    spans.push_back({i, end - i});
    i = end - 1;
  }
  return spans;
}

std::size_t tries() {
  const char* wanted = std::getenv("GANGLION_EXTREME_NUMBERS");
  return wanted != nullptr ? static_cast<std::size_t>(std::atoi(wanted)) : 300;
}

class ExtremeNumbers : public FolderTest {
 protected:
  ExtremeNumbers() {
    for (const char* kept : {"experiments", "examples"}) {
      fs::copy(fs::path(GANGLION_SOURCE_DIR) / kept, folder_ / kept, fs::copy_options::recursive);
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.path().filename() == "experiment.toml") experiments_.push_back(entry.path());
    }
    std::sort(experiments_.begin(), experiments_.end());
  }

  std::vector<fs::path> experiments_;
};

/// Every file beside the experiment that holds numbers, itself included; those that it uses are among them.
std::vector<fs::path> files_of(const fs::path& experiment) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(experiment.parent_path())) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether a run is refused. One that is not comes to the end of its first tick, and says that it was ended then.
bool refused(const fs::path& experiment, const std::string& told) {
  Problems problems;
  const auto prepared = prepare(experiment, {}, problems);
  if (!prepared) return true;
  int asked = 0;
  const auto result = run(*prepared, {.seed = prepared->experiment.seed, .stop = [&] { return ++asked > 0; }});
  if (!result) return true;
  const bool one_tick = prepared->experiment.duration_s < 1.5 * prepared->step_s;
  const bool early = result->reason.en.starts_with("duration over");
  EXPECT_TRUE(!early || one_tick) << told << ": " << result->reason.en;
  return false;
}

/// A draw below a bound, the same on every machine.
class Chance {
 public:
  std::size_t below(std::size_t bound) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return (state_ >> 33) % bound;
  }

 private:
  std::uint64_t state_ = 12345;
};

/// The text with a number exchanged, or a key added; `told` says which.
std::string spoilt(std::string text, const fs::path& file, Chance& chance, std::string& told) {
  const char* extreme = kExtremes[chance.below(kExtremes.size())];
  const Key& key = kKeys[chance.below(kKeys.size())];
  const std::size_t at = text.find(key.behind);
  if (chance.below(3) == 0 && file.stem().string().starts_with(key.file) && at != std::string::npos) {
    const std::string line = fmt::format(fmt::runtime(key.line), extreme);
    told += fmt::format("{}: {}", file.filename().string(), line);
    return text.insert(at + key.behind.size(), line);
  }
  const std::vector<Span> spans = numbers_in(text);
  if (spans.empty()) return text;
  const Span span = spans[chance.below(spans.size())];
  told += fmt::format("{}: {} at byte {} for {}\n", file.filename().string(), extreme, span.at,
                      text.substr(span.at, span.length));
  return text.replace(span.at, span.length, extreme);
}

TEST_F(ExtremeNumbers, AreRefusedWithTheirPlaceOrRun) {
  ASSERT_FALSE(experiments_.empty());
  Chance chance;
  std::size_t refusals = 0;
  const std::size_t count = tries();
  for (std::size_t i = 0; i < count; ++i) {
    const fs::path& experiment = experiments_[i % experiments_.size()];
    const std::vector<fs::path> files = files_of(experiment);
    std::string told = experiment.parent_path().filename().string() + " ";
    std::vector<std::pair<fs::path, std::string>> good;
    for (std::size_t n = 0; n < 1 + i % 3; ++n) {
      const fs::path& file = files[chance.below(files.size())];
      good.emplace_back(file, *read_file(file));
      ASSERT_TRUE(write_file(file, spoilt(good.back().second, file, chance, told)));
    }
    SCOPED_TRACE(told);
    if (std::getenv("GANGLION_EXTREME_NUMBERS") != nullptr) fmt::print(stderr, "{} {}", i, told);
    Problems problems;
    check_file(experiment, problems);
    for (const Error& error : problems.sorted()) {
      EXPECT_FALSE(error.place.file.empty()) << error.text();
      EXPECT_GT(error.place.line, 0) << error.text();
    }
    EXPECT_EQ(!problems.empty(), refused(experiment, told)) << problems.text();
    refusals += problems.empty() ? 0 : 1;
    for (auto one = good.rbegin(); one != good.rend(); ++one) ASSERT_TRUE(write_file(one->first, one->second));
  }
  EXPECT_GT(refusals, count / 10);
  EXPECT_LT(refusals, count * 9 / 10);
}

}  // namespace
}  // namespace ganglion
