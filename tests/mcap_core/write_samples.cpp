// write_samples FOLDER: run files of several shapes for verify.mjs, which are counted in verify.cmake.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "ganglion/base/file.h"
#include "ganglion/record/recover.h"
#include "ganglion/record/run_recorder.h"

namespace ganglion {
namespace {

const RunInfo kInfo{
    .name = "sample", .seed = 7, .tick_s = 0.1, .robots = {"robot0", "robot1"}, .versions = {{"ganglion", "0"}}};

Result<void> write_full_run(const std::filesystem::path& path) {
  McapWriterOptions options;
  options.chunk_bytes = 16384;
  auto recorder = RunRecorder::create(path, kInfo, std::move(options));
  if (!recorder) return tl::unexpected(recorder.error());
  recorder->attach("robot.toml", "format = 1\n");
  recorder->attach("empty", "");
  const std::vector<SignalColumn> columns(60, {"signal", "m"});
  const int first = recorder->add_table("/robot0/signals", columns);
  const int second = recorder->add_table("/robot1/signals", std::span(columns).first(1));
  recorder->add_table("/robot2/signals", columns);  // never written
  std::vector<double> row(60, std::numeric_limits<double>::quiet_NaN());
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    const double time_s = 0.1 * tick;
    for (std::size_t i = 0; i < 50; ++i) row[i] = std::sin(time_s + static_cast<double>(i));
    recorder->write_row(first, tick, time_s, row);
    if (tick % 10 == 0) recorder->write_row(second, tick, time_s, std::span(row).first(1));
    if (tick % 4 == 0) recorder->write_json("/robot0/pose", "foxglove.PoseInFrame", time_s, R"({"frame_id":"world"})");
    if (tick == 500) recorder->write_json("/robot0/map", "foxglove.Grid", time_s, R"({"data":"AAAA"})");
  }
  return recorder->finish(
      {.digest = "00", .verdict = Verdict::Succeeded, .reason = {"goal", "meta"}, .measures = {{"time_s", 100}}});
}

Result<void> write_empty_run(const std::filesystem::path& path) {
  auto recorder = RunRecorder::create(path, kInfo);
  if (!recorder) return tl::unexpected(recorder.error());
  return recorder->finish({});
}

/// The full run cut in the middle, and what is saved of it.
Result<void> write_recovered_run(const std::filesystem::path& full, const std::filesystem::path& path) {
  const auto bytes = read_file(full);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto saved = recover_run(std::string_view(*bytes).substr(0, bytes->size() / 2), full.string(), path);
  if (!saved) return tl::unexpected(saved.error());
  std::printf("saved %llu chunks\n", static_cast<unsigned long long>(saved->chunks));
  return {};
}

}  // namespace
}  // namespace ganglion

int main(int count, char** words) {
  if (count != 2) return 2;
  const std::filesystem::path folder = words[1];
  for (const auto& outcome :
       {ganglion::write_full_run(folder / "full.mcap"), ganglion::write_empty_run(folder / "empty.mcap"),
        ganglion::write_recovered_run(folder / "full.mcap", folder / "recovered.mcap")}) {
    if (outcome) continue;
    std::fprintf(stderr, "%s\n", outcome.error().text().c_str());
    return 1;
  }
  return 0;
}
