#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/record/mcap/writer.h"
#include "ganglion/record/run_info.h"
#include "ganglion/record/run_sink.h"
#include "ganglion/record/signal_table.h"

namespace ganglion {

/// Records one run into an MCAP file (design: run files). Called between ticks; failures of the disk never reach the
/// robot: they are kept and given by status() and finish().
///
/// Tables are channels of protobuf messages ganglion.Signals, what is shown of messages ganglion.Exhibit. Views for other people's programs are channels of JSON
/// whose schemas are named as Foxglove's viewers know them ("foxglove.PoseInFrame", "foxglove.LaserScan"...) or
/// "ganglion.*". Every message's time is the run's own, from 0 [ns]: two runs of one seed have the same messages, byte
/// for byte.
class RunRecorder final : public RunSink {
 public:
  /// Fails with Unwritable when the file cannot be made. A file without outcome tells of a run that was cut.
  static Result<RunRecorder> create(const std::filesystem::path& path, const RunInfo& info,
                                    McapWriterOptions options = {});

  int add_table(std::string_view topic, std::span<const SignalColumn> columns) override;
  void write_row(int table, std::uint32_t tick, double time_s, std::span<const double> values) override;
  void write_json(std::string_view topic, std::string_view schema_name, double time_s, std::string_view json) override;
  void write_exhibit(std::string_view topic, double time_s, std::string_view bytes) override;
  /// An input file, the experience the run started from...
  void attach(std::string_view name, std::string_view bytes);
  /// Starts all so far on its way to the disk: for a run that pauses.
  void flush() { writer_.flush_chunk(); }
  /// Writes the outcome and closes the file. Fails with the first failure of the run.
  Result<void> finish(const RunOutcome& outcome);
  Result<void> status() const { return writer_.status(); }
  /// Where it is written.
  std::filesystem::path path() const { return writer_.path(); }
  std::uint64_t bytes_written() const noexcept { return writer_.bytes_written(); }

 private:
  struct Channel {
    std::uint16_t id = 0;
    std::size_t columns = 0;
    std::uint32_t messages = 0;
  };

  explicit RunRecorder(McapWriter writer) : writer_(std::move(writer)) {}
  Channel& json_channel(std::string_view topic, std::string_view schema_name);

  McapWriter writer_;
  std::vector<Channel> tables_;
  std::map<std::string, Channel, std::less<>> json_channels_;
  std::map<std::string, std::uint16_t, std::less<>> json_schemas_;
  std::map<std::string, Channel, std::less<>> exhibits_;
  std::uint16_t signals_schema_ = 0, exhibit_schema_ = 0;
  std::string row_;  ///< Reused from tick to tick.
};

}  // namespace ganglion
