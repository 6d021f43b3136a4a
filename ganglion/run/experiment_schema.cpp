#include "ganglion/run/experiment_schema.h"

#include "ganglion/config/outline_schema.h"
#include "ganglion/run/experiment.h"

namespace ganglion {
namespace {

/// A fault begins at a time or within a range of times. There is no controller, by which the key is known as required.
constexpr std::string_view kSample = R"(format = 1
[[fault]]
target = "a"
kind = "dead"
from_s = 1
[[fault]]
target = "b"
kind = "dead"
from_s = [1, 2]
)";

}  // namespace

std::list<config::Outline> experiment_outlines() {
  std::list<config::Outline> samples;
  Problems problems;  // of the missing controller
  parse_experiment(kSample, "sample", problems, &samples.emplace_back());
  return samples;
}

std::string experiment_schema() { return config::schema_text("Ganglion experiment", experiment_outlines()); }

}  // namespace ganglion
