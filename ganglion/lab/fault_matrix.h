#pragma once

#include <string>
#include <vector>

#include "ganglion/lab/batch.h"

namespace ganglion::lab {

/// Faults that befall a robot together.
struct FaultCase {
  std::string name;  ///< "healthy", "sonar_left dead", "sonar_left dead + compass stuck"
  std::vector<Fault> faults;
};

/// More cases than this are refused: at twenty seeds each they would go on for days.
inline constexpr std::size_t kMaxFaultCases = 20'000;

/// Every single fault of what the controller uses, the healthy robot first: each wired sensor (tasks apart) dead,
/// stuck, biased, noisy, late; like sensors swapped; each element of a command weak; frames and commands lost or late.
/// Sizes are ours: 20 deg and 10 deg of bias and noise, 0.10 m and 0.05 m, 5 and 2.5 % of the range of other real
/// values; half the power; 0.5 s late for one sensor and 0.2 s for all; one frame in five lost.
/// With `pairs` every two of them on different targets as well. Fails with TooLarge over kMaxFaultCases.
Result<std::vector<FaultCase>> fault_cases(const Prepared& prepared, bool pairs);

/// How a batch went under one case.
struct FaultRow {
  std::string name;
  std::size_t runs = 0;
  std::size_t succeeded = 0;
  std::vector<std::pair<std::string, std::size_t>> met;  ///< Each criterion of success, and the runs that met it.
  std::vector<Quartiles> quartiles;
};

/// Carries out the jobs once for each case, its faults on top of the experiment's own and of theirs. Ends early, with
/// the cases so far, when options.progress says stop. Fails as fault_cases() and carry_out_all() do.
Result<std::vector<FaultRow>> run_fault_matrix(const Prepared& prepared, std::span<const Job> jobs,
                                               const BatchOptions& options, bool pairs);

}  // namespace ganglion::lab
