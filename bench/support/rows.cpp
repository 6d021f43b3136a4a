#include "bench/support/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <string_view>

namespace ganglion::bench {
namespace {

constexpr int kRounds = 3;

std::optional<double> ratio_of(const Row& row) {
  if (!row.rival) return std::nullopt;
  return row.unit.ends_with("/s") ? row.ours / *row.rival : *row.rival / row.ours;
}

std::string json_of(std::optional<double> value) { return value ? fmt::format("{:.6g}", *value) : "null"; }
std::string text_of(std::optional<double> value) { return value ? fmt::format("{:.4g}", *value) : "-"; }

void print_json(const std::vector<Row>& rows) {
  fmt::print("[\n");
  for (const Row& row : rows) {
    fmt::print("{{\"name\": \"{}\", \"ours\": {}, \"rival\": {}, \"unit\": \"{}\", \"ratio\": {}}}{}\n", row.name,
               json_of(row.ours), json_of(row.rival), row.unit, json_of(ratio_of(row)),
               &row == &rows.back() ? "" : ",");
  }
  fmt::print("]\n");
}

}  // namespace

double cpu_s() noexcept {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> figures) {
  std::sort(figures.begin(), figures.end());
  return figures[figures.size() / 2];
}

Row measured(std::string name, std::string unit, const std::function<double()>& ours,
             const std::function<std::optional<double>()>& rival) {
  std::vector<double> mine, theirs;
  for (int round = 0; round < kRounds; ++round) {
    mine.push_back(ours());
    if (!rival) continue;
    if (const auto figure = rival()) theirs.push_back(*figure);
  }
  const auto other = theirs.size() == kRounds ? std::optional(median(theirs)) : std::nullopt;
  return {std::move(name), median(mine), other, std::move(unit)};
}

int print(const std::vector<Row>& rows, int argc, char** argv, const std::string& remarks) {
  if (std::any_of(argv + 1, argv + argc, [](std::string_view word) { return word == "--json"; })) {
    print_json(rows);
    return 0;
  }
  fmt::print("{:32} {:>12} {:>12} {:>8}  {}\n", "name", "ours", "rival", "ratio", "unit");
  for (const Row& row : rows) {
    fmt::print("{:32} {:>12} {:>12} {:>8}  {}\n", row.name, text_of(row.ours), text_of(row.rival),
               text_of(ratio_of(row)), row.unit);
  }
  fmt::print("{}", remarks);
  return 0;
}

}  // namespace ganglion::bench
