#include <gtest/gtest.h>

#include <functional>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/config/named_tables.h"
#include "ganglion/graph/model.h"
#include "ganglion/record/mcap/reader.h"
#include "ganglion/record/mcap/writer.h"
#include "ganglion/run/check_file.h"
#include "ganglion/sim/world/plan/plan.h"

// Files of absurd size come to a quick end, with the limit in the message. What lies just within is accepted elsewhere:
// by the tests of each reader.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

class Limits : public FolderTest {
 protected:
  /// The first complaint about a file of that content that is about a size.
  std::string complaint(const char* name, const std::string& text) const {
    EXPECT_TRUE(write_file(folder_ / name, text));
    Problems problems;
    check_file(folder_ / name, problems);
    for (const Error& error : problems.sorted()) {
      if (error.code != ErrorCode::TooLarge) continue;
      EXPECT_EQ(error.place.file, (folder_ / name).string());
      return error.what.en;
    }
    return "no complaint about size, but: " + problems.text().substr(0, 500);
  }
};

/// `count` times what is made for each number.
std::string repeated(std::size_t count, const std::function<std::string(std::size_t)>& make) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += make(i);
  return text;
}

std::string controller(const std::string& text) {
  return fmt::format("format = 1\nrobot = \"{}/experiments/nimrod/robot.toml\"\n", GANGLION_SOURCE_DIR) + text;
}

TEST_F(Limits, OfAControllersComponents) {
  const auto sensation = [](std::size_t i) {
    return fmt::format("[[sensation]]\nid = \"s{}\"\nchannel = \"sonar_left.range\"\n", i);
  };
  EXPECT_EQ(complaint("c.toml", controller(repeated(kMaxComponents + 1, sensation))), "more than 4096 components");
}

TEST_F(Limits, OfTheWiresOfOnePort) {
  const std::string wires = repeated(kMaxWires + 1, [](std::size_t i) { return fmt::format("\"c{}\", ", i); });
  const std::string text = "[[coordinator]]\nid = \"a\"\nkind = \"Priority\"\ncommand = \"drive\"\nin.commands = [";
  EXPECT_NE(complaint("c.toml", controller(text + wires + "]\n")).find("4096"), std::string::npos);
}

TEST_F(Limits, OfARobotsParts) {
  const auto sensor = [](std::size_t i) { return fmt::format("[[sensor]]\nid = \"s{}\"\nkind = \"Sonar\"\n", i); };
  const std::string body =
      "format = 1\nname = \"r\"\ntick_s = 0.1\n[body]\nlength_m = 0.2\nwidth_m = 0.2\n[drive]\nkind = \"Tracked\"\n";
  EXPECT_EQ(complaint("r.toml", body + repeated(config::kMaxNamedTables + 1, sensor)),
            "there are 1025 of [[sensor]]; the limit is 1024");
}

TEST_F(Limits, OfTheValuesOfAController) {
  // 300 values and their age: 3483 sensations have 1,048,383 values, with the next one they are over 2^20.
  const std::string names = repeated(300, [](std::size_t i) { return fmt::format("\"e{}\", ", i); });
  ASSERT_TRUE(write_file(
      folder_ / "wide.toml",
      "format = 1\nname = \"wide\"\ntick_s = 0.1\n[body]\nlength_m = 1\nwidth_m = 1\n[[sensation]]\nname = \"w\"\n"
      "elements = [" +
          names + "]\n"));
  const auto sensation = [](std::size_t i) { return fmt::format("[[sensation]]\nid = \"s{}\"\nchannel = \"w\"\n", i); };
  const std::string head = "format = 1\nrobot = \"wide.toml\"\n";
  EXPECT_EQ(complaint("c.toml", head + repeated(kMaxValues / 301 + 1, sensation)),
            "s3483: with it the signals have more than 1048576 values");
}

TEST_F(Limits, OfATrainersGoals) {
  const std::string body =
      "format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\n[drive]\nkind = \"Stepper\"\n"
      "[[sensor]]\nid = \"trainer\"\nkind = \"Trainer\"\ncells = [";
  EXPECT_NE(
      complaint("r.toml", body + repeated(10'001, [](std::size_t i) { return fmt::format("{}, 0, ", i); }) + "]\n")
          .find("cells has 10001 goals; the limit is 10000"),
      std::string::npos);
}

TEST_F(Limits, OfAWorld) {
  const auto world = [this](std::size_t count, const std::function<std::string(std::size_t)>& make) {
    return complaint("w.toml", "format = 1\nname = \"w\"\n" + repeated(count, make));
  };
  const auto expect_limit = [](const std::string& said, std::size_t count, std::size_t limit) {
    EXPECT_NE(said.find(std::to_string(count)), std::string::npos) << said;
    EXPECT_NE(said.find(std::to_string(limit)), std::string::npos) << said;
  };
  const auto disc = [](std::size_t i) {
    return fmt::format("[[disc]]\nx_m = {}\ny_m = {}\nradius_m = 0.2\n", i % 200, i / 200);
  };
  expect_limit(world(sim::kMaxDiscs + 1, disc), sim::kMaxDiscs + 1, sim::kMaxDiscs);
  const auto mover = [](std::size_t i) {
    return fmt::format("[[mover]]\nid = \"m{}\"\nradius_m = 0.2\nplaces = [[0, 0]]\n", i);
  };
  expect_limit(world(sim::kMaxMovers + 1, mover), sim::kMaxMovers + 1, sim::kMaxMovers);
  const auto spawn = [](std::size_t i) { return fmt::format("[[spawn]]\nid = \"s{}\"\nx_m = 0\ny_m = 0\n", i); };
  expect_limit(world(sim::kMaxSpawns + 1, spawn), sim::kMaxSpawns + 1, sim::kMaxSpawns);
  const std::string points =
      repeated(sim::kMaxPolygonPoints + 1, [](std::size_t i) { return fmt::format("[{}, {}], ", i, i * i % 7); });
  expect_limit(complaint("w.toml", "format = 1\n[[polygon]]\npoints = [" + points + "]\n"), sim::kMaxPolygonPoints + 1,
               sim::kMaxPolygonPoints);
}

TEST_F(Limits, OfATomlFile) {
  EXPECT_EQ(complaint("w.toml", "# " + std::string(std::size_t{4} << 20, 'a')),
            "has 4194306 bytes; the limit here is 4194304");
  const std::string deep = "x = " + std::string(200, '[') + std::string(200, ']');
  EXPECT_NE(complaint("w.toml", deep).find("nested deeper than"), std::string::npos);
  const std::string keys = repeated(10'001, [](std::size_t i) { return fmt::format("k{} = 1\n", i); });
  EXPECT_NE(complaint("w.toml", keys).find("10000"), std::string::npos);
}

TEST_F(Limits, OfAMap) {
  const std::string yaml =
      "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n";
  EXPECT_EQ(complaint("m.yaml", yaml + repeated(200, [](std::size_t i) { return fmt::format("k{}: 1\n", i); })),
            "has more than 100 keys; a map file needs six");
  EXPECT_EQ(complaint("m.yaml", yaml + "# " + std::string(70'000, 'a')),
            fmt::format("has {} bytes; a map file may have 65536", yaml.size() + 2 + 70'000));
  ASSERT_TRUE(write_file(folder_ / "m.pgm", "P5 9000 9000 255\n"));
  ASSERT_TRUE(write_file(folder_ / "m.yaml", yaml));
  Problems problems;
  check_file(folder_ / "m.yaml", problems);
  EXPECT_NE(problems.text().find("m.pgm"), std::string::npos) << problems.text();
  EXPECT_NE(problems.text().find("67108864"), std::string::npos) << problems.text();
}

TEST_F(Limits, OfARunFilesMessages) {
  McapWriterOptions options;
  options.durable = false;
  auto writer = *McapWriter::create(folder_ / "a.mcap", std::move(options));
  const auto channel = writer.add_channel("/a", 0, "x");
  writer.write(channel, 5, 5, 0, std::string(mcap::kMaxMessageBytes + 1, 'a'));
  writer.write(channel, 6, 6, 0, "small");
  const auto closed = writer.close();
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().what.en, "a message of 67108865 bytes at 5 ns was left out; the limit is 67108864");
  EXPECT_TRUE(fs::exists(folder_ / "a.mcap"));
}

/// Why the run file at that path is not read.
std::string refusal(const fs::path& path) {
  const auto read = read_mcap(path, Recover::No, {});
  if (read) return "none";
  EXPECT_EQ(read.error().code, ErrorCode::TooLarge);
  EXPECT_EQ(read.error().place.file, path.string());
  return read.error().what.en;
}

TEST_F(Limits, OfARunFilesDefinitions) {
  McapWriterOptions options;
  options.durable = false;
  auto writer = *McapWriter::create(folder_ / "a.mcap", std::move(options));
  for (int n = 0; n < 3; ++n) writer.metadata("big", {{"words", std::string(mcap::kMaxDefinitionBytes / 3, 'a')}});
  ASSERT_TRUE(writer.close());
  const std::string said = refusal(folder_ / "a.mcap");
  EXPECT_TRUE(said.ends_with(": over 67108864 bytes of schemas, channels and metadata")) << said;
  EXPECT_TRUE(said.starts_with("byte 447")) << said;  // behind two thirds of them
}

TEST_F(Limits, OfARunFilesAttachments) {
  McapWriterOptions options;
  options.durable = false;
  auto writer = *McapWriter::create(folder_ / "a.mcap", std::move(options));
  for (std::size_t n = 0; n <= mcap::kMaxAttachments; ++n) writer.attach("a", "text/plain", "");
  ASSERT_TRUE(writer.close());
  const std::string said = refusal(folder_ / "a.mcap");
  EXPECT_TRUE(said.ends_with(": over 65536 attachments")) << said;
}

}  // namespace
}  // namespace ganglion
