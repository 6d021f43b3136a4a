#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "ganglion/record/run_sink.h"
#include "ganglion/studio/live/ring.h"

namespace ganglion::studio {

/// One stream of a run's samples.
struct StreamInfo {
  std::string topic;  ///< "/robot0/signals"
  std::vector<SignalColumn> columns;
};

/// From a run to those who watch it: the run's thread writes, another reads, and the run never waits. Rows that nobody
/// fetches in time are left out; what is told once (goals, log) and the newest of what changes (maps, routes, movers)
/// are kept until there is room.
class LiveFeed final : public RunSink {
 public:
  struct Row {
    int table = 0;
    std::uint32_t tick = 0;
    std::uint32_t seq = 0;
    double time_s = 0;
    std::size_t count = 0;
    std::vector<double> values;
  };
  struct Message {
    std::string topic;
    std::string schema;
    double time_s = 0;
    std::string json;
  };

  LiveFeed();

  // By the run's thread.
  int add_table(std::string_view topic, std::span<const SignalColumn> columns) override;
  void write_row(int table, std::uint32_t tick, double time_s, std::span<const double> values) override;
  void write_json(std::string_view topic, std::string_view schema_name, double time_s, std::string_view json) override;
  void write_exhibit(std::string_view topic, double time_s, std::string_view bytes) override;
  bool archives() const noexcept override { return false; }
  /// All tables are there: rows may be read from now on. Before the first tick.
  void arm();
  /// At the end: hands over what is still kept; true when nothing is left.
  bool flush();

  // By the thread that reads. Null = nothing there now.
  bool armed() const noexcept { return armed_.load(std::memory_order_acquire); }
  const std::vector<StreamInfo>& tables() const noexcept { return tables_; }  ///< Once armed.
  const Row* row() noexcept { return rows_ ? rows_->front() : nullptr; }
  void pop_row() noexcept { rows_->pop(); }
  Message* message() noexcept { return messages_.front(); }
  void pop_message() noexcept { messages_.pop(); }

 private:
  bool push(Message& message);

  std::vector<StreamInfo> tables_;
  std::vector<std::uint32_t> seqs_;
  std::unique_ptr<Ring<Row>> rows_;
  Ring<Message> messages_;
  std::deque<Message> kept_;  ///< What found no room.
  std::atomic<bool> armed_ = false;
};

}  // namespace ganglion::studio
