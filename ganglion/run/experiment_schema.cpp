#include "ganglion/run/experiment_schema.h"

#include "ganglion/config/outline_schema.h"
#include "ganglion/run/experiment.h"

namespace ganglion {

std::list<config::Outline> experiment_outlines() {
  std::list<config::Outline> samples;
  Problems problems;  // that the sample names no controller, by which the key is known to be required
  parse_experiment("format = 1\n", "sample", problems, &samples.emplace_back());
  return samples;
}

std::string experiment_schema() { return config::schema_text("Ganglion experiment", experiment_outlines()); }

}  // namespace ganglion
