#include "ganglion/studio/live/feed.h"

#include <algorithm>

#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/studio/live/messages.h"

namespace ganglion::studio {
namespace {

constexpr std::size_t kMessages = 1024;
constexpr std::size_t kRows = 1024;          // 10 s at 100 Hz
constexpr std::size_t kRowsOfEach = 4;       // where there are many robots
constexpr std::size_t kRowValues = 4 << 20;  // in all: 32 MiB

}  // namespace

LiveFeed::LiveFeed() : messages_(kMessages, {}) {}

int LiveFeed::add_table(std::string_view topic, std::span<const SignalColumn> columns) {
  tables_.push_back({std::string(topic), {columns.begin(), columns.end()}});
  return static_cast<int>(tables_.size()) - 1;
}

void LiveFeed::arm() {
  Row row;
  std::size_t widest = 1;
  for (const StreamInfo& table : tables_) widest = std::max(widest, table.columns.size());
  row.values.resize(widest);
  const std::size_t wanted = std::max(kRows, kRowsOfEach * tables_.size());
  rows_ = std::make_unique<Ring<Row>>(std::clamp(kRowValues / widest, std::size_t{16}, wanted), row);
  seqs_.assign(tables_.size(), 0);
  armed_.store(true, std::memory_order_release);
}

void LiveFeed::write_row(int table, std::uint32_t tick, double time_s, std::span<const double> values) {
  flush();
  const std::uint32_t seq = ++seqs_[static_cast<std::size_t>(table)];
  Row* row = rows_->free_slot();
  if (row == nullptr) return;
  row->table = table;
  row->tick = tick;
  row->seq = seq;
  row->time_s = time_s;
  row->count = values.size();
  std::copy(values.begin(), values.end(), row->values.begin());
  rows_->push();
}

void LiveFeed::write_json(std::string_view topic, std::string_view schema_name, double time_s, std::string_view json) {
  Message message{std::string(topic), std::string(schema_name), time_s, std::string(json)};
  if (flush() && push(message)) return;
  const auto older = !sample_kind_of(topic, schema_name)
                         ? kept_.end()
                         : std::find_if(kept_.begin(), kept_.end(), [&](const Message& m) { return m.topic == topic; });
  if (older != kept_.end()) {
    *older = std::move(message);
  } else {
    kept_.push_back(std::move(message));
  }
}

void LiveFeed::write_exhibit(std::string_view topic, double time_s, std::string_view bytes) {
  write_json(topic, kExhibitSchema, time_s, bytes);
}

bool LiveFeed::push(Message& message) {
  Message* slot = messages_.free_slot();
  if (slot == nullptr) return false;
  *slot = std::move(message);
  messages_.push();
  return true;
}

bool LiveFeed::flush() {
  while (!kept_.empty() && push(kept_.front())) kept_.pop_front();
  return kept_.empty();
}

}  // namespace ganglion::studio
