#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ganglion/lab/carry_out.h"

namespace ganglion::lab {

/// How many runs are carried out together.
struct BatchOptions {
  int threads = 0;                           ///< 0 = one for each processor.
  std::vector<ModuleExperience> experience;  ///< Every run starts with a copy of its own, dropped at its end.
  std::function<Keep(const Job&)> keep;      ///< Empty: nothing is kept.
  std::function<bool(std::size_t done, std::size_t all)> progress;  ///< From any thread, one at a time; false = stop.
  std::function<bool()> stop;  ///< Asked from every thread between ticks; true ends all runs, each with a whole file.
};

/// The same job with every seed up to the last.
std::vector<Job> each_seed(Job first, std::uint64_t last_seed);

/// Carries out every job of one experiment, in parallel; outcomes stand in the order of the jobs, whatever thread did
/// them, without those that were not begun. A run that could not be carried out stops the batch with its error; want of
/// memory in any thread is thrown from here, as std::bad_alloc.
Result<std::vector<Outcome>> carry_out_all(const Prepared& prepared, std::span<const Job> jobs,
                                           const BatchOptions& options);

/// Lower quartile, median and upper quartile of one measure over a batch, NaN left out (math::quantile).
struct Quartiles {
  std::string name;
  double lower = 0;
  double median = 0;
  double upper = 0;
};
std::vector<Quartiles> quartiles(const std::vector<Outcome>& outcomes);

}  // namespace ganglion::lab
