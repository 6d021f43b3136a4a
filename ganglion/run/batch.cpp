#include "ganglion/run/batch.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <thread>

#include "ganglion/math/quantile.h"

namespace ganglion {
namespace {

/// What the threads of a batch share.
struct Work {
  const Prepared& prepared;
  const BatchOptions& options;
  std::vector<std::optional<RunResult>> results{};
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::atomic<bool> out_of_memory{false};
  std::mutex mutex{};  // guards what follows
  std::size_t done = 0;
  std::optional<Error> error{};
};

void work_through_seeds(Work& work) {
  while (!work.stop) {
    const std::size_t index = work.next++;
    if (index >= work.results.size()) return;
    RunOptions options;
    options.seed = work.options.first_seed + index;
    options.experience = work.options.experience;
    if (work.options.run_file) options.run_file = work.options.run_file(options.seed);
    options.stop = [&work] {
      if (work.options.stop && work.options.stop()) work.stop = true;
      return work.stop.load();
    };
    auto result = run(work.prepared, options);
    const std::scoped_lock lock(work.mutex);
    ++work.done;
    if (result) {
      work.results[index] = std::move(*result);
    } else if (!work.error) {
      work.error = result.error();
      work.stop = true;
    }
    if (work.options.progress && !work.options.progress(work.done, work.results.size())) work.stop = true;
  }
}

/// The same; want of memory is kept for the thread that asked for the batch.
void work_through(Work& work) noexcept {
  try {
    work_through_seeds(work);
  } catch (const std::bad_alloc&) {
    work.out_of_memory = work.stop = true;
  }
}

}  // namespace

Result<std::vector<RunResult>> run_batch(const Prepared& prepared, const BatchOptions& options) {
  expects(options.last_seed >= options.first_seed);
  Work work{prepared, options};
  work.results.resize(options.last_seed - options.first_seed + 1);
  const bool one_robot = !prepared.experiment.link.address.empty();  // only one run at a time can command it
  const unsigned threads = one_robot             ? 1u
                           : options.threads > 0 ? static_cast<unsigned>(options.threads)
                                                 : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> pool;
    for (unsigned i = 0; i < threads; ++i) pool.emplace_back([&work] { work_through(work); });
  }
  if (work.out_of_memory) throw std::bad_alloc();
  if (work.error) return tl::unexpected<Error>(*work.error);
  std::vector<RunResult> results;
  for (auto& result : work.results) {
    if (result) results.push_back(std::move(*result));
  }
  return results;
}

std::vector<Quartiles> quartiles(const std::vector<RunResult>& results) {
  std::vector<Quartiles> summary;
  if (results.empty()) return summary;
  for (const auto& [name, first] : results.front().measures) {
    std::vector<double> values;
    for (const RunResult& result : results) values.push_back(measure(result.measures, name));
    summary.push_back({name, math::quantile(values, 0.25), math::quantile(values, 0.5), math::quantile(values, 0.75)});
  }
  return summary;
}

}  // namespace ganglion
