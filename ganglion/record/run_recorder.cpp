#include "ganglion/record/run_recorder.h"

#include <array>
#include <cmath>

#include "ganglion/base/expects.h"
#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/record/signals.h"

namespace ganglion {
namespace {

std::uint64_t to_ns(double time_s) noexcept {
  constexpr double kMost = 9e18;  // 285 years; also keeps the conversion defined
  const double time_ns = time_s * 1e9;
  return time_ns > 0 ? static_cast<std::uint64_t>(std::llround(std::min(time_ns, kMost))) : 0;
}

std::string json_schema(std::string_view name) {
  // Viewers take bytes inside JSON for text unless the schema says base64; the grid is the one view that has some.
  const std::string_view properties =
      name == "foxglove.Grid" ? R"(,"properties":{"data":{"type":"string","contentEncoding":"base64"}})" : "";
  return fmt::format(R"({{"title":"{}","type":"object"{}}})", name, properties);
}

std::string_view media_type_of(std::string_view name) noexcept {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTypes = {
      {{".toml", "application/toml"},
       {".json", "application/json"},
       {".csv", "text/csv"},
       {".fll", "text/plain"},
       {".yaml", "application/yaml"},
       {".pgm", "image/x-portable-graymap"}}};
  for (const auto& [suffix, type] : kTypes) {
    if (name.ends_with(suffix)) return type;
  }
  return "application/octet-stream";
}

}  // namespace

Result<RunRecorder> RunRecorder::create(const std::filesystem::path& path, const RunInfo& info,
                                        McapWriterOptions options) {
  auto writer = McapWriter::create(path, std::move(options));
  if (!writer) return tl::unexpected(writer.error());
  writer->metadata(kRunMetadata, to_fields(info));
  return RunRecorder(std::move(*writer));
}

int RunRecorder::add_table(std::string_view topic, std::span<const SignalColumn> columns) {
  if (signals_schema_ == 0) signals_schema_ = writer_.add_schema(kSignalsSchema, "protobuf", signals_descriptor());
  std::vector<std::string> names, units;
  for (const SignalColumn& column : columns) {
    names.push_back(column.name);
    units.push_back(column.unit);
  }
  const auto id = writer_.add_channel(topic, signals_schema_, "protobuf",
                                      {{"columns", to_lines(names)}, {"units", to_lines(units)}});
  tables_.push_back({id, columns.size(), 0});
  return static_cast<int>(tables_.size()) - 1;
}

void RunRecorder::write_row(int table, std::uint32_t tick, double time_s, std::span<const double> values) {
  expects(table >= 0 && static_cast<std::size_t>(table) < tables_.size());
  Channel& channel = tables_[static_cast<std::size_t>(table)];
  expects(values.size() == channel.columns);
  encode_signals(tick, time_s, values, row_);
  const std::uint64_t time_ns = to_ns(time_s);
  writer_.write(channel.id, time_ns, time_ns, channel.messages++, row_);
}

RunRecorder::Channel& RunRecorder::json_channel(std::string_view topic, std::string_view schema_name) {
  if (const auto known = json_channels_.find(topic); known != json_channels_.end()) return known->second;
  auto schema = json_schemas_.find(schema_name);
  if (schema == json_schemas_.end()) {
    const auto id = writer_.add_schema(schema_name, "jsonschema", json_schema(schema_name));
    schema = json_schemas_.emplace(schema_name, id).first;
  }
  const auto id = writer_.add_channel(topic, schema->second, "json");
  return json_channels_.emplace(topic, Channel{id, 0, 0}).first->second;
}

void RunRecorder::write_json(std::string_view topic, std::string_view schema_name, double time_s,
                             std::string_view json) {
  Channel& channel = json_channel(topic, schema_name);
  const std::uint64_t time_ns = to_ns(time_s);
  writer_.write(channel.id, time_ns, time_ns, channel.messages++, json);
}

void RunRecorder::write_exhibit(std::string_view topic, double time_s, std::string_view bytes) {
  auto known = exhibits_.find(topic);
  if (known == exhibits_.end()) {
    if (exhibit_schema_ == 0) exhibit_schema_ = writer_.add_schema(kExhibitSchema, "protobuf", exhibit_descriptor());
    known = exhibits_.emplace(topic, Channel{writer_.add_channel(topic, exhibit_schema_, "protobuf"), 0, 0}).first;
  }
  const std::uint64_t time_ns = to_ns(time_s);
  writer_.write(known->second.id, time_ns, time_ns, known->second.messages++, bytes);
}

void RunRecorder::attach(std::string_view name, std::string_view bytes) {
  writer_.attach(name, media_type_of(name), bytes);
}

Result<void> RunRecorder::finish(const RunOutcome& outcome) {
  writer_.metadata(kOutcomeMetadata, to_fields(outcome));
  return writer_.close();
}

}  // namespace ganglion
