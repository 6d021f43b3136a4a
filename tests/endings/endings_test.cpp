#include <gtest/gtest.h>

#include <fmt/format.h>

#include <csignal>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/record/run_file.h"
#include "tests/endings/child.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

const std::string kNimrod = std::string(GANGLION_SOURCE_DIR) + "/experiments/nimrod";

class Endings : public FolderTest {
 protected:
  /// A run of nearly three hours that has only just begun: nobody waits for its end.
  std::vector<std::string> long_run(const std::string& more = "--no-report") const {
    return {"run",   kNimrod, "--seed", "1",   "--set", "run.duration_s=10000", "--set", "run.free_ground=false",
            "--out", folder_, "--pace", "20x", more};
  }
  fs::path run_file() const { return folder_ / "seed_0001.mcap"; }

  void expect_whole_and_interrupted(const fs::path& file) const {
    const auto run = RunFile::read(file);  // Recover::No: whole
    ASSERT_TRUE(run) << run.error().text();
    ASSERT_TRUE(run->outcome);
    EXPECT_TRUE(run->outcome->reason.en.starts_with("interrupted")) << run->outcome->reason.en;
    EXPECT_EQ(run->outcome->verdict, Verdict::Failed);
    EXPECT_EQ(run->outcome->digest.size(), 16u);
    ASSERT_FALSE(run->tables.empty());
    EXPECT_GE(run->tables.front().rows(), 1u);
    EXPECT_LT(run->tables.front().rows(), 100'000u);
  }
};

TEST_F(Endings, OfARunByCtrlCOrTerminationLeaveAWholeFile) {
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove(run_file());
    Child program(folder_, long_run());
    ASSERT_TRUE(program.wait_for(run_file(), 1)) << program.err();
    program.send(signal);
    EXPECT_EQ(program.wait(), 1);
    EXPECT_NE(program.out().find("interrupted"), std::string::npos);
    expect_whole_and_interrupted(run_file());
    Child replay(folder_, {"replay", run_file()});
    EXPECT_EQ(replay.wait(), 0) << replay.out() << replay.err();
  }
}

TEST_F(Endings, OfManyRunsByCtrlCLeaveWholeFiles) {
  Child program(folder_, {"run", kNimrod, "--seeds", "1..8", "--threads", "2", "--set", "run.duration_s=1000000",
                          "--set", "run.free_ground=false", "--out", folder_});
  ASSERT_TRUE(program.wait_for(run_file(), 1)) << program.err();
  ASSERT_TRUE(program.wait_for(folder_ / "seed_0002.mcap", 1)) << program.err();
  program.send(SIGINT);
  EXPECT_EQ(program.wait(), 0) << program.err();
  expect_whole_and_interrupted(run_file());
  expect_whole_and_interrupted(folder_ / "seed_0002.mcap");
  EXPECT_FALSE(fs::exists(folder_ / "seed_0003.mcap"));
}

TEST_F(Endings, ByKillLeaveAFileThatIsRecovered) {
  std::vector<std::string> words = long_run();
  words[words.size() - 2] = "max";
  Child program(folder_, words);
  ASSERT_TRUE(program.wait_for(run_file(), 100'000)) << program.err();
  program.send(SIGKILL);
  EXPECT_EQ(program.wait(), -SIGKILL);
  EXPECT_FALSE(fs::exists(run_file()));
  const fs::path left = being_written(run_file());
  EXPECT_FALSE(RunFile::read(left));
  Child listed(folder_, {"runs", "list", folder_});
  EXPECT_EQ(listed.wait(), 0);
  EXPECT_NE(listed.out().find("cut"), std::string::npos) << "found among the others: " << listed.out();
  Child recover(folder_, {"runs", "recover", left, "--out", folder_ / "saved.mcap"});
  EXPECT_EQ(recover.wait(), 0) << recover.err();
  EXPECT_NE(recover.out().find("its outcome is lost"), std::string::npos) << recover.out();
  const auto run = RunFile::read(folder_ / "saved.mcap");
  ASSERT_TRUE(run) << run.error().text();
  EXPECT_GT(run->tables.front().rows(), 100u);
}

TEST_F(Endings, ByKillLeaveTheirExperienceToTheNextRunWhichWasRefusedUntilThen) {
  const std::string pathfinder = std::string(GANGLION_SOURCE_DIR) + "/experiments/pathfinder";
  const auto learn = [&](const fs::path& out, const std::string& pace) {
    return std::vector<std::string>{"run",
                                    pathfinder,
                                    "--seed",
                                    "1",
                                    "--out",
                                    out,
                                    "--pace",
                                    pace,
                                    "--no-report",
                                    "--experience",
                                    folder_ / "map.sqlite"};
  };
  Child first(folder_, learn(folder_, "1x"));
  ASSERT_TRUE(first.wait_for(run_file(), 1)) << first.err();
  fs::create_directories(folder_ / "second");
  Child second(folder_ / "second", learn(folder_ / "second", "max"));
  EXPECT_EQ(second.wait(), 4);
  EXPECT_NE(second.err().find("map.sqlite: is being written to by a run of \"Pathfinder"), std::string::npos)
      << second.err();
  EXPECT_NE(second.err().find(fmt::format("process {},", first.process())), std::string::npos) << second.err();
  first.send(SIGKILL);
  EXPECT_EQ(first.wait(), -SIGKILL);
  Child heir(folder_ / "second", learn(folder_ / "second", "max"));
  EXPECT_EQ(heir.wait(), 0) << heir.err();
}

TEST_F(Endings, OnAFullDiskTellTheResultAndLeaveWhatWasWritten) {
  Child program(folder_,
                {"run", kNimrod, "--seed", "1", "--set", "run.free_ground=false", "--set", "run.duration_s=2000",
                 "--out", folder_, "--json"},
                {.file_bytes = 200'000});
  EXPECT_EQ(program.wait(), 4);
  EXPECT_NE(program.err().find(".mcap: cannot be written: File too large"), std::string::npos) << program.err();
  EXPECT_NE(program.out().find("\"digest\""), std::string::npos) << program.out();
  Child recover(folder_, {"runs", "recover", being_written(run_file()), "--out", folder_ / "saved.mcap"});
  EXPECT_EQ(recover.wait(), 0) << recover.err();
  EXPECT_TRUE(RunFile::read(folder_ / "saved.mcap"));
}

TEST_F(Endings, WithoutMemoryAreToldInOneSentence) {
#ifdef GANGLION_SHADOW_MEMORY
  GTEST_SKIP() << "NOT TESTED here: a sanitizer needs more address space than the limit leaves";
#endif
  ASSERT_TRUE(write_file(folder_ / "field.toml", "format = 1\narea = [0, 0, 500, 500]\n"));
  for (const std::string option : {"--seed=1", "--seeds=1..4"}) {  // in the first thread, and in those of a batch
    Child program(folder_,
                  {"run", kNimrod, option, "--no-record", "--set", "application.robots=10000", "--set",
                   "run.duration_s=1", "--set", "application.world=" + (folder_ / "field.toml").string()},
                  {.memory_bytes = std::uint64_t{200} << 20});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_EQ(program.err(), "out of memory: take fewer robots, threads or seeds, or a smaller world\n");
  }
}

TEST_F(Endings, WithoutAPlaceToWriteToAreTold) {
  ASSERT_TRUE(write_file(folder_ / "file", "in the way"));
  Child run(folder_, {"run", kNimrod, "--set", "run.duration_s=1", "--out", folder_ / "file" / "runs"});
  EXPECT_EQ(run.wait(), 4);
  EXPECT_NE(run.err().find("cannot be written: Not a directory"), std::string::npos) << run.err();
  Child output(folder_, {"run", kNimrod, "--set", "run.duration_s=1", "--no-record", "--json"},
               {.output = "/dev/full"});
  EXPECT_EQ(output.wait(), 4);
}

TEST_F(Endings, WithoutTheirOwnRunFileAreTold) {
  Child program(folder_, long_run("--json"));
  ASSERT_TRUE(program.wait_for(run_file(), 1)) << program.err();
  fs::remove(being_written(run_file()));
  program.send(SIGINT);
  EXPECT_EQ(program.wait(), 4);
  EXPECT_NE(program.err().find("seed_0001.mcap: cannot be written: No such file"), std::string::npos) << program.err();
  EXPECT_NE(program.out().find("\"digest\""), std::string::npos) << "the result is told all the same";
}

TEST_F(Endings, WithFilesThatCannotBeReadAreTold) {
  fs::create_directories(folder_ / "experiment");
  fs::copy(kNimrod, folder_ / "experiment", fs::copy_options::recursive);
  const auto told = [&](const std::string& words) {
    Child program(folder_, {"run", folder_ / "experiment", "--no-record"});
    EXPECT_EQ(program.wait(), 2);
    EXPECT_NE(program.err().find(words), std::string::npos) << program.err();
  };
  fs::remove(folder_ / "experiment/office.toml");
  told("office.toml");
  fs::create_directories(folder_ / "experiment/office.toml");
  told("is not a regular file");
  fs::remove_all(folder_ / "experiment/office.toml");
  fs::create_symlink("/dev/zero", folder_ / "experiment/office.toml");
  told("is not a regular file");
  fs::remove(folder_ / "experiment/experiment.toml");
  told("experiment.toml: there is no such file");
}

/// Without chunks, index or summary, as other programs write them.
std::string foreign_file(std::string_view more) {
  const auto record = [](char opcode, const std::string& content) {
    std::string bytes(1, opcode);
    for (int byte = 0; byte < 8; ++byte) bytes += static_cast<char>(content.size() >> (8 * byte) & 0xff);
    return bytes + content;
  };
  const std::string magic("\x89MCAP0\r\n", 8), two_empty_texts(8, '\0');
  return magic + record(1, two_empty_texts) + std::string(more) + record(15, std::string(4, '\0')) +
         record(2, std::string(20, '\0')) + magic;
}

TEST_F(Endings, OfVerifyTellWhetherAFileOfAnotherProgramIsWhole) {
  ASSERT_TRUE(write_file(folder_ / "foreign.mcap", foreign_file("")));
  ASSERT_TRUE(write_file(folder_ / "damaged.mcap", foreign_file(std::string("\x05\x01\0\0\0\0\0\0\0x", 10))));
  Child whole(folder_, {"runs", "verify", folder_ / "foreign.mcap"});
  EXPECT_EQ(whole.wait(), 0) << whole.err();
  EXPECT_NE(whole.out().find("foreign.mcap: whole, of another program (?): no run, 0 messages"), std::string::npos)
      << whole.out();
  Child damaged(folder_, {"runs", "verify", folder_ / "damaged.mcap"});
  EXPECT_EQ(damaged.wait(), 2);
  EXPECT_NE(damaged.err().find("byte 25: a message is damaged"), std::string::npos) << damaged.err();
}

}  // namespace
}  // namespace ganglion
