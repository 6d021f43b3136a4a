#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/record/mcap/reader.h"
#include "ganglion/record/run_info.h"
#include "ganglion/record/signal_table.h"

namespace ganglion {

struct JsonMessage {
  double time_s = 0;
  std::string text;
};

/// All messages of one topic, in the order they were written.
struct JsonTopic {
  std::string schema_name;  ///< "foxglove.PoseInFrame"...
  std::vector<JsonMessage> messages;
};

/// One state of something that was shown, not looked into (ganglion/record/exhibit/exhibit_codec.h).
struct ExhibitMessage {
  double time_s = 0;
  std::string bytes;
};

/// A recorded run, read whole.
struct RunFile {
  RunInfo info;
  std::optional<RunOutcome> outcome;  ///< None when the run was cut.
  std::vector<mcap::Attachment> attachments;
  std::vector<SignalTable> tables;
  std::map<std::string, JsonTopic, std::less<>> json;                        ///< By topic.
  std::map<std::string, std::vector<ExhibitMessage>, std::less<>> exhibits;  ///< By topic.
  std::vector<Sentence> damages;  ///< What Recover::Yes passed over, in words.
  bool without_gaps = true;       ///< Nothing was left out as far as it goes (McapContent).

  /// Fails with NotFound, Unreadable, TooLarge, Syntax (no MCAP file), Unsupported (an MCAP file, but not of a run) or
  /// Corrupt; a cut or damaged file can be read with Recover::Yes as far as it goes.
  static Result<RunFile> read(const std::filesystem::path& path, Recover recover = Recover::No);
  /// Info, outcome and attachments only, without unpacking the messages.
  static Result<RunFile> read_summary(const std::filesystem::path& path, Recover recover = Recover::No);

  /// The same of bytes in memory, `name` being the file's name in messages; what unpacks to more than so many bytes in
  /// all is TooLarge, damaged or not.
  static Result<RunFile> parse(std::string_view bytes, const std::string& name, Recover recover,
                               std::size_t max_unpacked_bytes);
  static Result<RunFile> parse_summary(std::string_view bytes, const std::string& name, Recover recover);

  const SignalTable* table(std::string_view topic) const noexcept;
  const mcap::Attachment* attachment(std::string_view name) const noexcept;
};

}  // namespace ganglion
