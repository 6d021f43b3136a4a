#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/record/mcap/reader.h"
#include "ganglion/record/mcap/writer.h"

namespace ganglion {

struct Got {
  std::string topic;
  mcap::Message message;
  std::string data;
};

inline MessageSink collect(std::vector<Got>& into) {
  return [&into](const mcap::Channel& channel, const mcap::Message& message) {
    into.push_back({channel.topic, message, std::string(message.data)});
  };
}

/// A test that writes one file, with a clock that stands still unless it is set.
class McapTest : public FolderTest {
 protected:
  McapTest() {
    options_.durable = false;
    options_.now_ns = [this] { return now_ns_; };
  }

  std::filesystem::path path() const { return folder_ / "a.mcap"; }
  std::string content() const { return *read_file(path()); }

  /// Three chunks of two messages on two channels, an attachment and metadata; the bytes on disk after each chunk.
  std::vector<std::uint64_t> write_sample() {
    auto writer = *McapWriter::create(path(), std::move(options_));
    const auto schema = writer.add_schema("test.Note", "jsonschema", R"({"type":"object"})");
    const auto notes = writer.add_channel("/notes", schema, "json", {{"unit", "m"}, {"robot", "0"}});
    const auto raw = writer.add_channel("/raw", 0, "x-raw");
    writer.attach("robot.toml", "application/toml", "format = 1\n");
    writer.metadata("test", {{"seed", "7"}});
    std::vector<std::uint64_t> ends;
    for (std::uint32_t i = 0; i < 3; ++i) {
      writer.write(notes, 1000 * i, 1000 * i + 1, i, "{\"i\":" + std::to_string(i) + "}");
      writer.write(raw, 1000 * i + 500, 1000 * i + 500, i, std::string(100, static_cast<char>('a' + i)));
      writer.flush_chunk();
      ends.push_back(writer.bytes_written());
    }
    EXPECT_TRUE(writer.close());
    return ends;
  }

  std::int64_t now_ns_ = 0;
  McapWriterOptions options_;
};

}  // namespace ganglion
