#include "ganglion/record/recover.h"

#include <algorithm>

#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/record/mcap/reader.h"
#include "ganglion/record/run_info.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNumbers = 65535;  // of channels or schemas, counted from 1 in two bytes

std::vector<std::string> english(const std::vector<Sentence>& sentences) {
  std::vector<std::string> texts;
  for (const Sentence& one : sentences) texts.push_back(one.en);
  return texts;
}

/// Writes what was read into a new file.
class Rewriter {
 public:
  Rewriter(McapWriter& writer, const McapContent& content) : writer_(writer), content_(content) {}

  void write_definitions(const Recovery& recovery) {
    for (const mcap::Metadata& record : content_.metadata) {
      if (record.name != kOutcomeMetadata) writer_.metadata(record.name, record.fields);
    }
    writer_.metadata(kRecoveredMetadata, {{"chunks", std::to_string(recovery.chunks)},
                                          {"messages", std::to_string(recovery.messages)},
                                          {"until_s", shortest(recovery.until_s)},
                                          {"damages", to_lines(english(recovery.damages))}});
    for (const mcap::Attachment& one : content_.attachments) {
      writer_.attach(one.name, one.media_type, one.bytes, one.log_time_ns);
    }
    std::map<std::uint16_t, std::uint16_t> schemas = {{std::uint16_t{0}, std::uint16_t{0}}};
    for (const auto& [id, schema] : content_.schemas) {
      schemas[id] = writer_.add_schema(schema.name, schema.encoding, schema.data);
    }
    for (const auto& [id, channel] : content_.channels) {
      channels_[id] =
          writer_.add_channel(channel.topic, schemas.at(channel.schema), channel.message_encoding, channel.metadata);
    }
  }

  void write(const mcap::Channel& channel, const mcap::Message& message) {
    writer_.write(channels_.at(channel.id), message.log_time_ns, message.publish_time_ns, message.sequence,
                  message.data);
  }

  /// Last, as in a run that was not cut.
  void write_outcome() {
    for (const mcap::Metadata& record : content_.metadata) {
      if (record.name == kOutcomeMetadata) writer_.metadata(record.name, record.fields);
    }
  }

 private:
  McapWriter& writer_;
  const McapContent& content_;
  std::map<std::uint16_t, std::uint16_t> channels_;
};

bool has(const McapContent& content, std::string_view metadata) {
  return std::any_of(content.metadata.begin(), content.metadata.end(),
                     [&](const mcap::Metadata& record) { return record.name == metadata; });
}

Result<void> check(const McapContent& content, const std::string& name) {
  if (!has(content, kRunMetadata)) {
    return fail_at({name}, ErrorCode::Unsupported,
                   {"nothing to recover: there is no whole metadata \"{}\" in it",
                    "no hay nada que recuperar: no tiene metadatos \"{}\" enteros"},
                   kRunMetadata);
  }
  if (content.channels.size() > kMostNumbers || content.schemas.size() > kMostNumbers) {
    return fail_at({name}, ErrorCode::TooLarge,
                   {"has over {} channels or schemas", "tiene más de {} canales o esquemas"}, kMostNumbers);
  }
  return {};
}

Result<void> rewrite(std::string_view bytes, const std::string& name, const McapContent& content,
                     const Recovery& recovery, const fs::path& to, McapWriterOptions options) {
  auto writer = McapWriter::create(to, std::move(options));
  if (!writer) return tl::unexpected(writer.error());
  Rewriter rewriter(*writer, content);
  rewriter.write_definitions(recovery);
  const auto again = parse_mcap(bytes, name, Recover::Yes,
                                [&](const auto& channel, const auto& message) { rewriter.write(channel, message); });
  if (!again) return tl::unexpected(again.error());
  rewriter.write_outcome();
  return writer->close();
}

}  // namespace

Result<Recovery> recover_run(std::string_view bytes, const std::string& name, const fs::path& to,
                             McapWriterOptions options) {
  Recovery recovery;
  std::uint64_t latest_ns = 0;
  auto content = parse_mcap(bytes, name, Recover::Yes, [&](const mcap::Channel&, const mcap::Message& message) {
    latest_ns = std::max(latest_ns, message.log_time_ns);
  });
  if (!content) return tl::unexpected(content.error());
  if (auto checked = check(*content, name); !checked) return tl::unexpected(checked.error());
  recovery.chunks = content->chunks;
  recovery.messages = content->messages;
  recovery.until_s = static_cast<double>(latest_ns) * 1e-9;
  recovery.finished = has(*content, kOutcomeMetadata);
  recovery.damages = content->damages;
  if (auto written = rewrite(bytes, name, *content, recovery, to, std::move(options)); !written)
    return tl::unexpected(written.error());
  return recovery;
}

Result<Recovery> recover_run(const fs::path& from, const fs::path& to, McapWriterOptions options) {
  std::error_code ignored;
  if (fs::equivalent(from, to, ignored)) {
    return fail_at({to.string()}, ErrorCode::BadParameter,
                   {"is the file to recover: write to another one", "es el archivo que se recupera: escriba en otro"});
  }
  const auto bytes = read_file(from, mcap::kMaxMcapFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return recover_run(*bytes, from.string(), to, std::move(options));
}

}  // namespace ganglion
