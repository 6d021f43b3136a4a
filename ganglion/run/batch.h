#pragma once

#include <functional>
#include <vector>

#include "ganglion/run/run.h"

namespace ganglion {

struct BatchOptions {
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 1;
  int threads = 0;                           ///< 0 = one for each processor.
  std::vector<ModuleExperience> experience;  ///< Every run starts with a copy of its own, dropped at its end.
  std::function<std::filesystem::path(std::uint64_t seed)> run_file;  ///< Empty: nothing is recorded.
  std::function<bool(std::size_t done, std::size_t all)> progress;    ///< From any thread, one at a time; false = stop.
  std::function<bool()> stop;  ///< Asked from every thread between ticks; true ends all runs, each with a whole file.
};

/// Runs every seed, in parallel; results stand in order of the seeds, whatever thread did them. A run that could not be
/// carried out stops the batch with its error; want of memory in any thread is thrown from here, as std::bad_alloc.
Result<std::vector<RunResult>> run_batch(const Prepared& prepared, const BatchOptions& options);

/// Lower quartile, median and upper quartile of one measure over a batch, NaN left out (math::quantile).
struct Quartiles {
  std::string name;
  double lower = 0;
  double median = 0;
  double upper = 0;
};
std::vector<Quartiles> quartiles(const std::vector<RunResult>& results);

}  // namespace ganglion
