#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "ganglion/base/file.h"
#include "ganglion/record/mcap/compression.h"
#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/run_recorder.h"
#include "ganglion/studio/live/recording_view.h"
#include "ganglion/studio/server/testing/bench.h"

// What somebody who may ask could send to end the server or make it hang.
namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

using Hostile = ServerTest;

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

TEST_F(Hostile, SurvivesJsonNestedAHundredThousandDeep) {
  const Client client = client_of();
  const std::string list = repeated("[", 100'000) + repeated("]", 100'000);
  const std::string object = repeated("{\"a\":", 100'000) + "1" + repeated("}", 100'000);
  for (const std::string& deep : {list, object}) {
    for (const char* path : {"/api/file/open", "/api/document/edit", "/api/document/copy", "/api/run/start"}) {
      for (const std::string& body :
           {deep, "{\"path\":\"controller.toml\",\"operations\":" + deep + ",\"ids\":" + deep + "}",
            "{\"path\":\"controller.toml\",\"operations\":[{\"op\":\"set\",\"id\":\"\",\"key\":\"x\",\"value\":" +
                deep + "}],\"set\":" + deep + "}"}) {
        EXPECT_EQ(client.send("POST", path, body).status, 400u) << path;
      }
    }
  }
  EXPECT_EQ(client.get("/api/run").status, 200u);
}

/// Read in the order they stand in, each key is compared with all before it: 8 MiB of them would take an hour.
TEST_F(Hostile, RefusesAnObjectOfSoManyKeysThatReadingItWouldTakeForever) {
  const Client client = client_of();
  const auto body_of = [](int keys) {
    std::string body = R"({"path":"controller.toml","more":{)";
    for (int i = 0; i < keys; ++i) body += fmt::format("\"k{}\":1,", i);
    return body + R"("last":1}})";
  };
  const Answer refused = client.send("POST", "/api/file/open", body_of(600'000));
  EXPECT_EQ(refused.status, 413u);
  EXPECT_EQ(refused.json()["error"]["code"], "TooLarge");
  EXPECT_EQ(client.send("POST", "/api/file/open", body_of(10'000)).status, 200u) << "as many as a drawing has boxes";
}

TEST_F(Hostile, TellsWhichTableOfATextHasTooManyKeys) {
  const Client client = client_of();
  std::string text = "format = 1\n\n[[acting]]\nid = \"a\"\n";
  for (int i = 0; i < 333'000; ++i) text += fmt::format("k{:x} = 1\n", i);
  const Answer opened = client.post("/api/document/open", {{"path", "controller.toml"}, {"text", text}});
  ASSERT_EQ(opened.status, 200u);
  const auto problems = opened.json()["model"]["problems"];
  const auto told = std::find_if(problems.begin(), problems.end(), [](const auto& one) { return one["line"] == 3; });
  ASSERT_NE(told, problems.end()) << problems;
  EXPECT_EQ((*told)["code"], "TooLarge");
  EXPECT_EQ((*told)["message"], "has 333001 keys; the limit of a table is 10000");
  const Answer edited =
      client.post("/api/document/edit", {{"path", "controller.toml"},
                                         {"text", text},
                                         {"operations", {{{"op", "set"}, {"id", "a"}, {"key", "k9"}, {"value", 2}}}}});
  EXPECT_EQ(edited.status, 200u);
  EXPECT_EQ(client.post("/api/document/targets", {{"path", "controller.toml"}, {"text", text}, {"id", "a"}}).status,
            200u);
}

TEST_F(Hostile, SaysWhatIsNoFileWithoutAFailureOfItsOwn) {
  const Client client = client_of();
  std::filesystem::create_directories(folder() / "x.toml");
  ASSERT_EQ(::mkfifo((folder() / "pipe.toml").c_str(), 0600), 0);
  for (const char* name : {"x.toml", "pipe.toml"}) {
    EXPECT_EQ(client.post("/api/file/open", {{"path", name}}).status, 422u) << name;
    EXPECT_EQ(client.post("/api/recording/open", {{"path", name}}).status, 422u) << name;
  }
  EXPECT_EQ(client.post("/api/file/save", {{"path", "controller.toml/x.toml"}, {"text", ""}, {"based_on", ""}}).status,
            404u);
}

/// A header, a channel, and chunks that each unpack to four messages of 60 MiB: some 200 KB that say they are 2 GiB.
std::string bomb() {
  std::string inner, packed, bytes(mcap::kMagic);
  mcap::FieldWriter in(inner), out(bytes);
  auto record = in.begin_record(mcap::Opcode::Channel);
  in.u16(1);
  in.u16(0);
  for (const char* text : {"/notes", "json"}) in.string(text);
  in.map({});
  in.end_record(record);
  for (int i = 0; i < 4; ++i) {
    record = in.begin_record(mcap::Opcode::Message);
    in.u16(1);
    in.u32(0);
    in.u64(5);
    in.u64(5);
    inner.append(std::size_t{60} << 20, ' ');
    in.end_record(record);
  }
  EXPECT_TRUE(mcap::Compressor(1).compress(inner, packed));
  record = out.begin_record(mcap::Opcode::Header);
  out.string("");
  out.string("");
  out.end_record(record);
  for (int i = 0; i < 9; ++i) {
    record = out.begin_record(mcap::Opcode::Chunk);
    out.u64(5);
    out.u64(5);
    out.u64(inner.size());
    out.u32(0);
    out.string("zstd");
    out.u64(packed.size());
    out.bytes(packed);
    out.end_record(record);
  }
  return bytes;
}

long peak_kib() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

TEST_F(Hostile, UnpacksNoMoreOfARunFileThanItsLimit) {
  const Client client = client_of();
  ASSERT_TRUE(write_file(folder() / "bomb.mcap", bomb()));
  const long before_kib = peak_kib();
  const Answer opened = client.post("/api/recording/open", {{"path", "bomb.mcap"}});
  EXPECT_EQ(opened.status, 413u);
  EXPECT_EQ(opened.json()["error"]["code"], "TooLarge");
  EXPECT_EQ(client.get("/api/recording/report?path=bomb.mcap").status, 413u);
  EXPECT_LT(peak_kib() - before_kib, 1 << 20) << "twice the limit of 512 MiB";
  EXPECT_EQ(client.get("/api/files").status, 200u);
}

/// Cut, or with a byte that lies, at every seventh place: in heads of records, lengths and checksums.
TEST_F(Hostile, ReadsOfALyingRunFileWhatItCan) {
  const Client client = client_of();
  const fs::path file = folder() / "run.mcap";
  {
    auto recorder = RunRecorder::create(file, {.name = "lie", .seed = 7, .tick_s = 0.1});
    ASSERT_TRUE(recorder);
    const int table = recorder->add_table("/robot0/signals", std::vector<SignalColumn>{{"range", "m"}});
    for (std::uint32_t tick = 0; tick < 4; ++tick) {
      recorder->write_row(table, tick, 0.1 * tick, std::vector<double>{0.5 * tick});
    }
    ASSERT_TRUE(
        recorder->finish({.digest = "00", .verdict = ganglion::Verdict::Succeeded, .reason = {"goal", "meta"}}));
  }
  const std::string whole = read_file(file).value();
  ASSERT_EQ(client.post("/api/recording/open", {{"path", "run.mcap"}}).status, 200u);
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    std::string lies = whole;
    lies[at] = static_cast<char>(0xff);
    for (const std::string& bytes : {whole.substr(0, at), lies}) {
      ASSERT_TRUE(write_file(file, bytes));
      const Answer opened = client.post("/api/recording/open", {{"path", "run.mcap"}});
      EXPECT_TRUE(opened.status == 200 || opened.status == 400 || opened.status == 422) << at << ": " << opened.status;
      EXPECT_FALSE(opened.status != 200 && opened.json()["error"]["message"].empty());
    }
  }
  EXPECT_EQ(client.get("/api/run").status, 200u);
}

/// A text whose every line asks for a look at all that follows.
TEST_F(Hostile, OpensTextsThatAreAllSlips) {
#ifdef __SANITIZE_ADDRESS__
  constexpr std::size_t kBytes = 100'000;  // twenty times as slow
#else
  constexpr std::size_t kBytes = 300'000;
#endif
  const Client client = client_of();
  for (const std::string& line : {std::string("a = [\n"), std::string("a = { b = \n"), std::string("a = [ \"\"\" ' \n"),
                                  std::string("garbage\n"), std::string("[goal.x]\n"), std::string("a = 1\n")}) {
    const std::string text = "format = 1\n" + repeated(line, static_cast<int>(kBytes / line.size()));
    EXPECT_EQ(client.post("/api/document/open", {{"path", "controller.toml"}, {"text", text}}).status, 200u) << line;
  }
}

TEST_F(Hostile, RefusesAnEditThatWouldTakeForever) {
  const Client client = client_of();
  nlohmann::ordered_json operations = nlohmann::ordered_json::array();
  for (int i = 0; i < 20'000; ++i) operations.push_back({{"op", "set"}, {"id", ""}, {"key", "name"}, {"value", i}});
  const std::string text = "format = 1\n#" + std::string(1 << 20, 'x') + "\n";
  const Answer answer =
      client.post("/api/document/edit", {{"path", "controller.toml"}, {"text", text}, {"operations", operations}});
  EXPECT_EQ(answer.status, 413u);
  EXPECT_EQ(answer.json()["error"]["code"], "TooLarge");
}

TEST(HostileRecording, ShowsNothingOfWhatIsNoExhibit) {
  RunFile file;
  file.exhibits["/robot0/exhibit/a/field/map"] = {{0, "no message"}, {1, std::string(1000, '\xff')}};
  file.exhibits["/robot0/exhibit/a/marks/" + std::string(100'000, 'x')] = {{0, ""}};
  const RecordingView view(std::move(file));
  EXPECT_TRUE(view.head(Language::English)["streams"].empty());
  EXPECT_TRUE(view.samples(0, 1e9, 1).empty());
}

}  // namespace
}  // namespace ganglion::studio
