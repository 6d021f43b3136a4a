#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ganglion::bench {

/// One line of a benchmark's table.
struct Row {
  std::string name;
  double ours = 0;
  std::optional<double> rival;  ///< None where there is none, or where it is not installed.
  std::string unit;             ///< A rate ends in "/s": more is better. Of all else less is better.
};

/// CPU seconds of this process so far: other work on the machine does not count.
double cpu_s() noexcept;

/// The middle one of an odd number of figures.
double median(std::vector<double> figures);

/// Median of ours and of the rival's figure over three rounds, taken in turn so that both see the same machine. A rival
/// that gives nothing stays out.
Row measured(std::string name, std::string unit, const std::function<double()>& ours,
             const std::function<std::optional<double>()>& rival = {});

/// Prints the table, or with --json among the arguments an array of {name, ours, rival, unit, ratio} and nothing else.
/// `ratio` says how many times better ours is; null without a rival. `remarks` go to the table only.
int print(const std::vector<Row>& rows, int argc, char** argv, const std::string& remarks = {});

}  // namespace ganglion::bench
