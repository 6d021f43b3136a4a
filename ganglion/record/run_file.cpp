#include "ganglion/record/run_file.h"

#include <algorithm>

#include "ganglion/base/file.h"
#include "ganglion/record/exhibit/track.h"
#include "ganglion/record/signals.h"

namespace ganglion {
namespace {

std::string_view field(const mcap::Fields& fields, std::string_view key) noexcept {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& entry) { return entry.first == key; });
  return found != fields.end() ? std::string_view(found->second) : std::string_view();
}

/// Sorts messages into tables and topics.
class Collector {
 public:
  explicit Collector(RunFile& run) : run_(run) {}

  /// Lists a table even if it got no row.
  void declare(const mcap::Channel& channel) {
    if (is_table(channel)) table_of(channel);
  }

  void take(const mcap::Channel& channel, const mcap::Message& message) {
    if (channel.message_encoding == "json") {
      run_.json[channel.topic].messages.push_back(
          {static_cast<double>(message.log_time_ns) * 1e-9, std::string(message.data)});
    } else if (is_table(channel)) {
      take_row(channel, message);
    } else if (channel.message_encoding == "protobuf" && track_of(channel.topic)) {
      run_.exhibits[channel.topic].push_back(
          {static_cast<double>(message.log_time_ns) * 1e-9, std::string(message.data)});
    }
  }

  const std::optional<Error>& problem() const noexcept { return problem_; }

 private:
  static bool is_table(const mcap::Channel& channel) noexcept {
    return channel.message_encoding == "protobuf" && !field(channel.metadata, "columns").empty();
  }

  SignalTable& table_of(const mcap::Channel& channel) {
    const auto known = tables_.find(channel.id);
    if (known != tables_.end()) return run_.tables[known->second];
    tables_[channel.id] = run_.tables.size();
    SignalTable& table = run_.tables.emplace_back();
    table.topic = channel.topic;
    const auto names = from_lines(field(channel.metadata, "columns"));
    const auto units = from_lines(field(channel.metadata, "units"));
    for (std::size_t i = 0; i < names.size(); ++i) {
      table.columns.push_back({names[i], i < units.size() ? units[i] : std::string()});
    }
    return table;
  }

  void take_row(const mcap::Channel& channel, const mcap::Message& message) {
    SignalTable& table = table_of(channel);
    if (!decode_signals(message.data, row_) || row_.values.size() != table.columns.size()) {
      if (!problem_) {
        problem_ = Error{ErrorCode::Corrupt, say({"message {} of \"{}\" is no row of {} values",
                                                  "el mensaje {} de \"{}\" no es una fila de {} valores"},
                                                 message.sequence, channel.topic, table.columns.size())};
      }
      return;
    }
    table.ticks.push_back(row_.tick);
    table.times_s.push_back(row_.time_s);
    table.values.insert(table.values.end(), row_.values.begin(), row_.values.end());
  }

  RunFile& run_;
  std::map<std::uint16_t, std::size_t> tables_;
  SignalRow row_;
  std::optional<Error> problem_;
};

Result<void> take_metadata(const std::vector<mcap::Metadata>& metadata, RunFile& run) {
  bool found = false;
  for (const mcap::Metadata& record : metadata) {
    if (record.name == kRunMetadata) {
      auto info = run_info_from(record.fields);
      if (!info) return tl::unexpected(info.error());
      run.info = std::move(*info);
      found = true;
    } else if (record.name == kOutcomeMetadata) {
      auto outcome = run_outcome_from(record.fields);
      if (!outcome) return tl::unexpected(outcome.error());
      run.outcome = std::move(*outcome);
    }
  }
  if (!found) {
    return fail(ErrorCode::Unsupported,
                {"holds no run: there is no metadata \"{}\"", "no contiene ninguna ejecución: no hay metadatos \"{}\""},
                kRunMetadata);
  }
  return {};
}

enum class Messages { Left, Read };

Result<RunFile> parse_run(std::string_view bytes, const std::string& name, Recover recover, Messages messages,
                          std::size_t max_unpacked_bytes = mcap::kMaxUnpackedBytes) {
  RunFile run;
  Collector collector(run);
  MessageSink sink;
  if (messages == Messages::Read) {
    sink = [&](const mcap::Channel& channel, const mcap::Message& message) { collector.take(channel, message); };
  }
  auto content = parse_mcap(bytes, name, recover, sink, max_unpacked_bytes);
  if (!content) return tl::unexpected(content.error());
  for (const auto& [id, channel] : content->channels) {
    collector.declare(channel);
    const auto schema = content->schemas.find(channel.schema);
    const auto topic = run.json.find(channel.topic);
    if (topic != run.json.end() && schema != content->schemas.end()) topic->second.schema_name = schema->second.name;
  }
  run.damages = std::move(content->damages);
  run.without_gaps = content->without_gaps;
  auto outcome = take_metadata(content->metadata, run);
  if (outcome && collector.problem() && recover == Recover::No) outcome = tl::unexpected(*collector.problem());
  if (!outcome) {
    outcome.error().place.file = name;
    return tl::unexpected(outcome.error());
  }
  if (collector.problem()) run.damages.push_back(collector.problem()->what);
  run.attachments = std::move(content->attachments);
  return run;
}

Result<RunFile> read_run(const std::filesystem::path& path, Recover recover, Messages messages) {
  const auto bytes = read_file(path, mcap::kMaxMcapFileBytes);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return parse_run(*bytes, path.string(), recover, messages);
}

}  // namespace

Result<RunFile> RunFile::read(const std::filesystem::path& path, Recover recover) {
  return read_run(path, recover, Messages::Read);
}

Result<RunFile> RunFile::read_summary(const std::filesystem::path& path, Recover recover) {
  return read_run(path, recover, Messages::Left);
}

Result<RunFile> RunFile::parse(std::string_view bytes, const std::string& name, Recover recover,
                               std::size_t max_unpacked_bytes) {
  return parse_run(bytes, name, recover, Messages::Read, max_unpacked_bytes);
}

Result<RunFile> RunFile::parse_summary(std::string_view bytes, const std::string& name, Recover recover) {
  return parse_run(bytes, name, recover, Messages::Left);
}

const SignalTable* RunFile::table(std::string_view topic) const noexcept {
  const auto found =
      std::find_if(tables.begin(), tables.end(), [&](const auto& table) { return table.topic == topic; });
  return found != tables.end() ? &*found : nullptr;
}

const mcap::Attachment* RunFile::attachment(std::string_view name) const noexcept {
  const auto found =
      std::find_if(attachments.begin(), attachments.end(), [&](const auto& one) { return one.name == name; });
  return found != attachments.end() ? &*found : nullptr;
}

}  // namespace ganglion
