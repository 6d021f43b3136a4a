// make_seeds EXPERIMENTS FOLDER: good inputs for the fuzzers to start from, in FOLDER/toml, FOLDER/map, FOLDER/mcap and
// FOLDER/studio_edit, link_binary, link_json and link_packets.
#include <array>
#include <cstdio>

#include "fuzz/link/script.h"
#include "ganglion/base/file.h"
#include "ganglion/link/fault/frame_cutter.h"
#include "ganglion/link/testing/bench.h"
#include "ganglion/record/exhibit/testing/shows_all.h"
#include "ganglion/record/exhibit_recorder.h"
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

/// The shipped controllers, each with one of every operation of the page.
void seed_studio_edit(const fs::path& experiments, const fs::path& folder) {
  constexpr std::array kOperations = {
      R"([{"op":"add","class":"acting","kind":"Escape","position":[10,20],"set":{"trigger_range_m":0.1}}])",
      R"([{"op":"add","class":"sensation","id":"left","set":{"channel":"sonar_left.range"}}])",
      R"([{"op":"remove","ids":["escape","avoid"]}])",
      R"([{"op":"rename","id":"escape","to":"flee"}])",
      R"([{"op":"set","id":"escape","key":"trigger_range_m","value":[1,2.5]},{"op":"set","id":"","key":"name","value":"n"}])",
      R"([{"op":"unset","id":"escape","key":"trigger_range_m"}])",
      R"([{"op":"connect","from":"escape.active@previous","id":"hold","port":"displaced_by","index":0}])",
      R"([{"op":"disconnect","id":"arbiter","port":"commands","from":"avoid"},{"op":"disconnect","id":"escape","port":"left"}])",
      R"([{"op":"reorder","id":"arbiter","port":"commands","order":["hold","avoid","escape"]}])",
      R"([{"op":"move","positions":{"escape":[1,2],"avoid":[3,4]}}])",
      R"([{"op":"paste","toml":"[[acting]]\nid = \"escape\"\nkind = \"Escape\"\nin.left = \"clear_left\"\n[layout]\nescape = [1, 2]\n","offset":[20,20]}])"};
  for (const auto& entry : fs::recursive_directory_iterator(experiments)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("controller") || entry.path().extension() != ".toml") continue;
    const std::string of = entry.path().parent_path().filename().string();
    const std::string text = read_file(entry.path()).value_or("");
    for (std::size_t i = 0; i < kOperations.size(); ++i) {
      keep(folder / fmt::format("{}_{}_{}", of, name, i), text + '\0' + kOperations[i]);
    }
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
  ExhibitRecorder exhibits(*recorder);
  ShowsAll all;
  for (all.stage = 0; all.stage < 3; ++all.stage) exhibits.show(all, {0, "all"}, 0.2 * all.stage);
  good = good && recorder->finish({.digest = "00", .verdict = Verdict::Succeeded, .reason = {"goal", "meta"}});
}

/// The frames in some bytes, each a piece; the first of them some time after what was before.
void add(fuzz::Script& script, link::Carrier carrier, std::uint8_t wait, std::string_view bytes) {
  link::FrameCutter cutter(carrier);
  cutter.feed(bytes);
  while (auto frame = cutter.next()) script.pieces.push_back({std::exchange(wait, 0), std::move(*frame)});
}

std::vector<ActFrame> commands(std::uint32_t tick, const Description& robot) {
  std::vector<ActFrame> act(2, make_act_frame(robot));
  for (ActFrame& frame : act) {
    frame.values = {0.5, -0.25};
    frame.origins = {tick == 2 ? CommandOrigin::Withdrawn : CommandOrigin::Commanded};
    frame.reasons = {static_cast<std::uint16_t>(tick == 2 ? 3 : 0)};
    frame.ttl_s = {tick == 3 ? 0.04 : 0.3};
  }
  return act;
}

/// What both sides of a short session say, as the link targets take it: a greeting, a reset, five ticks, and goodbye.
void seed_session(const fs::path& folder, const std::string& name, const fuzz::Dialect& dialect, bool free_running) {
  const link::Carrier carrier = dialect.carrier;
  link::NotebookRobot robot(2);
  link::RobotEnd end(robot, link::robot_config());
  link::ControllerEndConfig config{.carrier = carrier, .encoding = dialect.encoding};
  config.pace = free_running ? link::wire::FREE_RUNNING : link::wire::LOCK_STEP;
  link::ControllerEnd controller(config);
  const auto peer = end.open(carrier, "", 0);
  fuzz::Script to_robot, to_controller;
  to_controller.to_controller = true;
  to_robot.free_running = to_controller.free_running = free_running;
  double now_s = 0;
  const auto exchange = [&](std::uint8_t wait) {
    add(to_robot, carrier, wait, controller.outgoing());
    end.receive(peer, controller.outgoing(), now_s);
    controller.outgoing().clear();
    now_s += fuzz::kWait_s * wait;
    end.poll(now_s);
    const std::string answer(end.outgoing(peer));
    end.sent(peer, answer.size(), now_s);
    add(to_controller, carrier, wait, answer);
    controller.receive(answer, now_s);
  };
  controller.greet(0);
  controller.connected(0);
  exchange(0);
  good = good && controller.done();
  controller.reset(7, 0, now_s);
  exchange(0);
  for (std::uint32_t tick = 0; tick < 5; ++tick) {
    controller.take_sense();
    controller.act(commands(tick, robot.description()), 0.1, now_s);
    if (free_running) controller.await_sense(now_s);
    exchange(5);
  }
  good = good && controller.done();
  controller.bye(say({"done", "listo"}));
  exchange(0);
  keep(folder / (name + "_to_robot"), to_robot.text());
  keep(folder / (name + "_to_controller"), to_controller.text());
}

void seed_link(const fs::path& folder) {
  using link::Carrier;
  using link::Encoding;
  for (const bool free_running : {false, true}) {
    const std::string pace = free_running ? "free" : "lock";
    seed_session(folder / "link_binary", pace, {Carrier::Stream, Encoding::Binary}, free_running);
    seed_session(folder / "link_json", pace, {Carrier::Stream, Encoding::Json}, free_running);
    seed_session(folder / "link_packets", pace, {Carrier::Packets, Encoding::Binary}, free_running);
    seed_session(folder / "link_packets", pace + "_json", {Carrier::Packets, Encoding::Json}, free_running);
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
  ganglion::seed_studio_edit(words[1], folder / "studio_edit");
  ganglion::seed_map(folder / "map");
  ganglion::seed_mcap(folder / "mcap");
  ganglion::seed_link(folder);
  ganglion::seed_c_robot(folder / "c_robot");
  return ganglion::good ? 0 : 1;
}
