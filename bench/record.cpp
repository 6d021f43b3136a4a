// What recording costs: microseconds and bytes a row of 60 columns, and of a pose, syncing to the disk included.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "bench/support/rows.h"
#include "ganglion/record/run_recorder.h"

namespace {

using namespace ganglion;
using namespace ganglion::bench;

constexpr int kRows = 100'000;

struct Cost {
  double us_per_row = 0;
  double bytes_per_row = 0;
};

/// Writes rows of `columns` slowly varying signals.
Cost record(std::size_t columns) {
  const auto path = std::filesystem::temp_directory_path() / ("bench_record_" + std::to_string(getpid()) + ".mcap");
  auto recorder = RunRecorder::create(path, {});
  if (!recorder) return {};
  const std::vector<SignalColumn> names(columns, SignalColumn{});
  const int table = recorder->add_table("signals", names);
  std::vector<double> values(columns);
  const double began_s = cpu_s();
  for (int n = 0; n < kRows; ++n) {
    for (std::size_t k = 0; k < columns; ++k) values[k] = std::fmod(0.013 * n * static_cast<double>(k + 1), 3.0);
    recorder->write_row(table, static_cast<std::uint32_t>(n), 0.1 * n, values);
  }
  const bool finished = recorder->finish({}).has_value();
  const Cost cost{(cpu_s() - began_s) * 1e6 / kRows, static_cast<double>(std::filesystem::file_size(path)) / kRows};
  std::filesystem::remove(path);
  return finished ? cost : Cost{};
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Row> rows;
  for (const std::size_t columns : {3, 60}) {
    const std::string name = "record/" + std::to_string(columns) + "_columns";
    double bytes = 0;
    rows.push_back(measured(name, "us", [&] {
      const Cost cost = record(columns);
      bytes = cost.bytes_per_row;
      return cost.us_per_row;
    }));
    rows.push_back({name + "/size", bytes, std::nullopt, "bytes"});
  }
  return print(rows, argc, argv, "A row is one tick's signals; CPU time, compression and system calls included.\n");
}
