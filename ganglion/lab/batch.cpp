#include "ganglion/lab/batch.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

#include "ganglion/math/quantile.h"

namespace ganglion::lab {
namespace {

/// What the threads of a batch share.
struct Work {
  const Prepared& prepared;
  std::span<const Job> jobs;
  const BatchOptions& options;
  std::vector<std::optional<Outcome>> outcomes{};
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::atomic<bool> out_of_memory{false};
  std::mutex mutex{};  // guards what follows
  std::size_t done = 0;
  std::optional<Error> error{};
};

void work_through_jobs(Work& work) {
  while (!work.stop) {
    const std::size_t index = work.next++;
    if (index >= work.jobs.size()) return;
    const Job& job = work.jobs[index];
    Hooks hooks;
    hooks.run.experience = work.options.experience;
    hooks.run.stop = [&work] {
      if (work.options.stop && work.options.stop()) work.stop = true;
      return work.stop.load();
    };
    auto outcome = carry_out(work.prepared, job, work.options.keep ? work.options.keep(job) : Keep{}, hooks);
    const std::scoped_lock lock(work.mutex);
    ++work.done;
    if (outcome) {
      work.outcomes[index] = std::move(*outcome);
    } else if (!work.error) {
      work.error = outcome.error();
      work.stop = true;
    }
    if (work.options.progress && !work.options.progress(work.done, work.jobs.size())) work.stop = true;
  }
}

/// The same; want of memory is kept for the thread that asked for the batch.
void work_through(Work& work) noexcept {
  try {
    work_through_jobs(work);
  } catch (const std::bad_alloc&) {
    work.out_of_memory = work.stop = true;
  }
}

}  // namespace

std::vector<Job> each_seed(Job first, std::uint64_t last_seed) {
  expects(last_seed >= first.seed);
  std::vector<Job> jobs(last_seed - first.seed + 1, first);
  for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].seed = first.seed + i;
  return jobs;
}

Result<std::vector<Outcome>> carry_out_all(const Prepared& prepared, std::span<const Job> jobs,
                                           const BatchOptions& options) {
  Work work{prepared, jobs, options};
  work.outcomes.resize(jobs.size());
  const bool one_robot = !prepared.experiment.link.address.empty();  // only one run at a time can command it
  const unsigned threads = one_robot             ? 1u
                           : options.threads > 0 ? static_cast<unsigned>(options.threads)
                                                 : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> pool;
    try {
      for (unsigned i = 0; i < threads; ++i) pool.emplace_back([&work] { work_through(work); });
    } catch (const std::system_error&) {  // fewer threads do as well, be it this one
      if (pool.empty()) work_through(work);
    }
  }
  if (work.out_of_memory) throw std::bad_alloc();
  if (work.error) return tl::unexpected<Error>(*work.error);
  std::vector<Outcome> outcomes;
  for (auto& outcome : work.outcomes) {
    if (outcome) outcomes.push_back(std::move(*outcome));
  }
  return outcomes;
}

std::vector<Quartiles> quartiles(const std::vector<Outcome>& outcomes) {
  std::vector<Quartiles> summary;
  if (outcomes.empty()) return summary;
  for (const auto& [name, first] : outcomes.front().figures) {
    std::vector<double> values;
    for (const Outcome& outcome : outcomes) values.push_back(measure(outcome.figures, name));
    summary.push_back({name, math::quantile(values, 0.25), math::quantile(values, 0.5), math::quantile(values, 0.75)});
  }
  return summary;
}

}  // namespace ganglion::lab
