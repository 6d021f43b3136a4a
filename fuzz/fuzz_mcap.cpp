// Run files. A file that is read strictly is read the same with recovery; whatever can be recovered makes a file that
// is whole, and holds as many messages as were counted.
#include "fuzz/target.h"
#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/record/exhibit/exhibit_json.h"
#include "ganglion/record/mcap/reader.h"
#include "ganglion/record/recover.h"
#include "ganglion/record/run_file.h"

namespace ganglion::fuzz {
namespace {

/// What is taken for an exhibit is one, and every state of a field follows from the one before.
void look_at_exhibits(const RunFile& run) {
  for (const auto& [topic, messages] : run.exhibits) {
    auto track = track_of(topic);
    must(track.has_value(), "a topic of an exhibit names one");
    for (const ExhibitMessage& message : messages) {
      if (auto state = decode_exhibit(message.bytes)) track->add(message.time_s, std::move(*state));
    }
    for_each_state(*track, [](double, const shown::Field& field) {
      for (const auto& cells : field.cells) {
        must(cells.size() == static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows),
             "a layer has all cells of its field");
      }
    });
    for (const shown::Exhibit& state : track->states) static_cast<void>(json_of(state).size());
  }
}

}  // namespace

void run_input(std::string_view input) {
  std::uint64_t strict = 0, lenient = 0;
  const auto count = [](std::uint64_t& into) {
    return [&into](const mcap::Channel& channel, const mcap::Message& message) {
      into += 1 + 0 * (channel.topic.size() + message.data.size());
    };
  };
  const auto whole = parse_mcap(input, "a.mcap", Recover::No, count(strict));
  const auto rest = parse_mcap(input, "a.mcap", Recover::Yes, count(lenient));
  static_cast<void>(parse_mcap(input, "a.mcap", Recover::Yes, {}));
  must(!whole || (rest && rest->damages.empty() && strict == lenient), "a whole file needs no recovery");

  const auto path = folder() / "recovered.mcap";
  McapWriterOptions options;
  options.durable = false;
  const auto recovery = recover_run(input, "a.mcap", path, std::move(options));
  if (!recovery) return;
  std::uint64_t found = 0;
  const auto again = read_mcap(path, Recover::No, count(found));
  must(again.has_value(), "a recovered file is whole", again ? "" : again.error().text());
  must(found == recovery->messages && found == lenient, "nothing is lost on the way");
  const auto run = RunFile::read(path, Recover::Yes);
  if (run) look_at_exhibits(*run);
}

}  // namespace ganglion::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ganglion::fuzz::run_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
