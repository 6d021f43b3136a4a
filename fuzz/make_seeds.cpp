// make_seeds EXPERIMENTS FOLDER: good inputs for the fuzzers to start from, in FOLDER/toml, FOLDER/map, FOLDER/mcap and
// FOLDER/link.
#include <cstdio>

#include "ganglion/base/file.h"
#include "ganglion/link/testing/bench.h"
#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/run_recorder.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

bool good = true;

void keep(const fs::path& path, std::string_view bytes) {
  const auto written = write_file(path, bytes);
  if (written) return;
  std::fprintf(stderr, "%s\n", written.error().text().c_str());
  good = false;
}

/// Which reader of fuzz_toml.cpp takes the file.
char reader_of(const std::string& name) {
  if (name.starts_with("experiment")) return 0;
  if (name.starts_with("controller")) return 1;
  return name.starts_with("robot") ? 2 : 3;
}

void seed_toml(const fs::path& experiments, const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(experiments)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().filename().string();
    const std::string of = entry.path().parent_path().filename().string();
    keep(folder / (of + "_" + name), reader_of(name) + read_file(entry.path()).value_or(""));
  }
}

void seed_map(const fs::path& folder) {
  const std::string plain = "P2\n# a map\n3 2\n255\n254 254 0\n205 254 0\n";
  const std::string binary = std::string("P5\n4 2\n255\n") + "\xfe\xfe\xfe\x01\x02\x03\xcd\xcd";
  const std::string deep =
      std::string("P5 2 2 65535\n") + std::string("\0\1\0\xc8\0\0\0\x10", 8);  // dark: all below 256
  const std::string yaml =
      "image: map.pgm\nresolution: 0.05\norigin: [-1.0, 2.0, 0.5]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\nmode: trinary\n";
  const std::string listed =
      "---\nimage: \"map.pgm\"  # note\norigin:\n  - 0\n  - 0\n  - 0\nresolution: 1e-1\n"
      "negate: 1\noccupied_thresh: 0.5\nfree_thresh: 0.5\n";
  keep(folder / "plain", '\0' + plain);
  keep(folder / "binary", '\0' + binary);
  keep(folder / "deep", '\0' + deep);
  keep(folder / "yaml", '\1' + yaml);
  keep(folder / "listed", '\1' + listed);
  keep(folder / "both", '\2' + yaml + '\0' + binary);
  keep(folder / "both_plain", '\2' + listed + '\0' + plain);
}

/// The records of a small run in a chunk that is neither packed nor checked, so that mutations reach the innermost
/// fields.
std::string unchecked_run() {
  std::string inner_bytes, bytes(mcap::kMagic);
  mcap::FieldWriter inner(inner_bytes), out(bytes);
  auto record = inner.begin_record(mcap::Opcode::Channel);
  inner.u16(1);
  inner.u16(0);
  for (const char* text : {"/notes", "json"}) inner.string(text);
  inner.map({{"unit", "m"}});
  inner.end_record(record);
  record = inner.begin_record(mcap::Opcode::Message);
  inner.u16(1);
  inner.u32(0);
  inner.u64(5);
  inner.u64(5);
  inner.bytes("{}");
  inner.end_record(record);
  record = out.begin_record(mcap::Opcode::Header);
  out.string("");
  out.string("seed");
  out.end_record(record);
  record = out.begin_record(mcap::Opcode::Metadata);
  out.string(kRunMetadata);
  out.map(to_fields(RunInfo{.name = "seed", .tick_s = 0.1}));
  out.end_record(record);
  record = out.begin_record(mcap::Opcode::Chunk);
  out.u64(5);
  out.u64(5);
  out.u64(inner_bytes.size());
  out.u32(0);
  out.string("");
  out.u64(inner_bytes.size());
  out.bytes(inner_bytes);
  out.end_record(record);
  return bytes;
}

void seed_mcap(const fs::path& folder) {
  keep(folder / "unchecked", unchecked_run());
  auto recorder = RunRecorder::create(folder / "whole", {.name = "seed", .seed = 7, .tick_s = 0.1});
  if (!recorder) {
    good = false;
    return;
  }
  recorder->attach("robot.toml", "format = 1\n");
  const int table = recorder->add_table("/robot0/signals", std::vector<SignalColumn>{{"range", "m"}});
  for (std::uint32_t tick = 0; tick < 6; ++tick) {
    recorder->write_row(table, tick, 0.1 * tick, std::vector<double>{0.5 * tick});
    recorder->write_json("/robot0/pose", "foxglove.PoseInFrame", 0.1 * tick, "{}");
    if (tick == 2) recorder->flush();
  }
  good = good && recorder->finish({.digest = "00", .success = true, .reason = "goal"});
}

/// What both sides of a short session say, as fuzz_link.cpp takes it.
void seed_session(const fs::path& folder, link::Carrier carrier, link::Encoding encoding) {
  link::NotebookRobot robot(2);
  link::RobotEnd end(robot, nullptr, link::robot_config());
  link::ControllerEnd controller({.carrier = carrier, .encoding = encoding});
  const auto peer = end.open(carrier, "", 0);
  const std::vector<ActFrame> act(2, make_act_frame(robot.description()));
  const char reader = carrier == link::Carrier::Stream ? 0 : 1;
  std::string to_robot(1, reader), to_controller(1, static_cast<char>(reader + 2));
  controller.greet(0);
  controller.connected(0);
  for (int tick = 0; tick < 5; ++tick) {
    if (tick > 0) controller.act(act, 0.1, 0);
    to_robot += controller.outgoing();
    end.receive(peer, controller.outgoing(), 0);
    controller.outgoing().clear();
    const std::string answer(end.outgoing(peer));
    end.sent(peer, answer.size(), 0);
    to_controller += answer;
    controller.receive(answer, 0);
  }
  good = good && controller.done();
  const std::string name =
      std::string(reader == 0 ? "tcp" : "serial") + (encoding == link::Encoding::Json ? "_json" : "_binary");
  keep(folder / (name + "_to_robot"), to_robot);
  keep(folder / (name + "_to_controller"), to_controller);
}

void seed_link(const fs::path& folder) {
  for (const link::Carrier carrier : {link::Carrier::Stream, link::Carrier::Packets}) {
    for (const link::Encoding encoding : {link::Encoding::Binary, link::Encoding::Json}) {
      seed_session(folder, carrier, encoding);
    }
  }
}

/// Pieces as fuzz_c_robot.cpp reads them: a session in either pace.
void seed_c_robot(const fs::path& folder) {
  for (const auto pace : {link::wire::LOCK_STEP, link::wire::FREE_RUNNING}) {
    std::string pieces;
    const auto say = [&pieces](const auto& message) {
      link::FrameWriter writer(link::Carrier::Stream, link::Encoding::Binary);
      std::string bytes;
      good = good && writer.append(message, bytes);
      const std::string payload = bytes.substr(4);  // without its length
      pieces += static_cast<char>(payload.size());
      pieces += payload;
      pieces += std::string_view("\0\x0a", 2);  // 100 ms
    };
    link::wire::Hello hello;
    hello.set_major(1);
    hello.set_pace(pace);
    say(hello);
    link::wire::Reset reset;
    reset.set_seed(7);
    say(reset);
    link::wire::Beat beat;
    beat.set_number(300);
    say(beat);
    link::wire::Act act;
    for (std::uint32_t tick = 0; tick < 3; ++tick) {
      act.set_tick(tick);
      act.set_ttl_ms(tick * 100);
      act.set_step_s(0.1 * tick);
      act.clear_values32();
      for (const float value : {0.5F, 7.0F}) act.add_values32(value);
      if (tick == 2) act.add_ttl_s(0.05);
      say(act);
    }
    hello.set_token("ihgfedcb");  // of 0x12345678
    say(hello);
    say(link::wire::Bye());
    keep(folder / std::to_string(pace), pieces);
  }
}

}  // namespace
}  // namespace ganglion

int main(int count, char** words) {
  if (count != 3) return 2;
  const ganglion::fs::path folder = words[2];
  ganglion::seed_toml(words[1], folder / "toml");
  ganglion::seed_map(folder / "map");
  ganglion::seed_mcap(folder / "mcap");
  ganglion::seed_link(folder / "link");
  ganglion::seed_c_robot(folder / "c_robot");
  return ganglion::good ? 0 : 1;
}
