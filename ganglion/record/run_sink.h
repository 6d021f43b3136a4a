#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ganglion/record/signal_table.h"

namespace ganglion {

/// Takes what a run tells of itself, between ticks: into a file, or to people who watch. It never alters the run.
class RunSink {
 public:
  RunSink() = default;
  RunSink(const RunSink&) = default;
  RunSink(RunSink&&) = default;
  RunSink& operator=(const RunSink&) = default;
  RunSink& operator=(RunSink&&) = default;
  virtual ~RunSink() = default;

  /// The number by which write_row() knows the table.
  virtual int add_table(std::string_view topic, std::span<const SignalColumn> columns) = 0;
  /// One row, as many values as the table has columns.
  virtual void write_row(int table, std::uint32_t tick, double time_s, std::span<const double> values) = 0;
  /// `json` is one object, not looked into. The first message of a topic makes its channel.
  virtual void write_json(std::string_view topic, std::string_view schema_name, double time_s,
                          std::string_view json) = 0;
  /// A state of something that is shown (ganglion/record/exhibit/exhibit.proto).
  virtual void write_exhibit(std::string_view topic, double time_s, std::string_view bytes) = 0;
  /// Keeps every message, so that changes are enough; else the newest counts and is told whole.
  virtual bool archives() const noexcept { return true; }
};

}  // namespace ganglion
