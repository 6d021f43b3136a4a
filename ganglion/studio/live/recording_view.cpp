#include "ganglion/studio/live/recording_view.h"

#include <algorithm>
#include <cstring>

#include "ganglion/plot/from_run_file.h"
#include "ganglion/studio/live/messages.h"

namespace ganglion::studio {
namespace {

/// A sample and when it was.
struct Timed {
  double time_s;
  std::string bytes;
};

Json latest_of(const RunFile& file, std::string_view topic) {
  const auto found = file.json.find(topic);
  return found != file.json.end() && !found->second.messages.empty() ? parsed(found->second.messages.front().text)
                                                                     : Json();
}

/// Read as JSON a text takes many times its size: of a file that holds nothing but events no more than these.
constexpr std::size_t kMostEvents = 100'000;
constexpr std::size_t kMostEventBytes = std::size_t{16} << 20;

Json events_of(const RunFile& file) {
  std::vector<std::pair<double, Json>> events;
  std::size_t bytes = 0;
  for (const auto& [topic, messages] : file.json) {
    for (const JsonMessage& message : messages.messages) {
      auto event = event_of(messages.schema_name, message.time_s, message.text);
      if (!event) continue;
      bytes += message.text.size();
      if (events.size() >= kMostEvents || bytes > kMostEventBytes) break;
      event->content["event"] = event->name;
      events.emplace_back(message.time_s, std::move(event->content));
    }
  }
  std::stable_sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Json list = Json::array();
  for (auto& [time_s, event] : events) list.push_back(std::move(event));
  return list;
}

void add_rows(const SignalTable& table, std::uint16_t stream, double from_s, double to_s, std::size_t every,
              std::vector<Timed>& samples) {
  for (std::size_t row = 0; row < table.rows(); row += every) {
    const double time_s = table.times_s[row];
    if (time_s < from_s || time_s > to_s) continue;
    const SampleHead head{stream, static_cast<std::uint32_t>(row + 1), time_s};
    samples.push_back({time_s, row_sample(head, table.ticks[row], table.row(row))});
  }
}

/// Of what counts from its time on: those in the time asked for, and the last one before.
template <class Use>
void for_each_between(const std::vector<double>& times_s, double from_s, double to_s, Use use) {
  for (std::size_t i = 0; i < times_s.size() && times_s[i] <= to_s; ++i) {
    const bool over = i + 1 < times_s.size() && times_s[i + 1] <= from_s;
    use(i, !over);
  }
}

void add_field(const ExhibitTrack& track, std::uint16_t stream, double from_s, double to_s,
               std::vector<Timed>& samples) {
  FieldState field;
  std::uint32_t told = 0;
  for_each_between(track.times_s, from_s, to_s, [&](std::size_t i, bool asked) {
    const auto seq = static_cast<std::uint32_t>(i + 1);
    if (!field.take(track.states[i], seq) || !asked) return;
    samples.push_back({track.times_s[i], field.sample({stream, seq, track.times_s[i]}, told)});
    told = seq;
  });
}

void add_exhibit(const ExhibitTrack& track, std::uint16_t stream, double from_s, double to_s,
                 std::vector<Timed>& samples) {
  for_each_between(track.times_s, from_s, to_s, [&](std::size_t i, bool asked) {
    if (!asked) return;
    const SampleHead head{stream, static_cast<std::uint32_t>(i + 1), track.times_s[i]};
    samples.push_back({head.time_s, exhibit_sample(head, track.states[i])});
  });
}

void add_movers(const JsonTopic& topic, std::uint16_t stream, double from_s, double to_s, std::vector<Timed>& samples) {
  std::vector<double> times_s;
  for (const JsonMessage& message : topic.messages) times_s.push_back(message.time_s);
  for_each_between(times_s, from_s, to_s, [&](std::size_t i, bool asked) {
    if (!asked) return;
    const SampleHead head{stream, static_cast<std::uint32_t>(i + 1), times_s[i]};
    samples.push_back({head.time_s, movers_sample(head, topic.messages[i].text)});
  });
}

}  // namespace

RecordingView::RecordingView(RunFile file) : file_(std::move(file)) {
  std::size_t unread = 0;
  exhibits_ = plot::exhibits_of(file_, unread);
  for (const auto& [topic, messages] : file_.json) {
    if (sample_kind_of(topic, messages.schema_name) == SampleKind::Movers) movers_ = &messages;
  }
}

double RecordingView::duration_s() const {
  double last_s = 0;
  for (const SignalTable& table : file_.tables) {
    if (table.rows() > 0) last_s = std::max(last_s, table.times_s.back());
  }
  return last_s;
}

Json RecordingView::head(Language language) const {
  Json damages = Json::array();
  for (const Sentence& damage : file_.damages) damages.push_back(damage.in(language));
  Json streams = Json::array();
  for (std::size_t i = 0; i < file_.tables.size(); ++i) {
    Json columns = Json::array();
    for (const SignalColumn& column : file_.tables[i].columns) {
      columns.push_back({{"name", column.name}, {"unit", column.unit}});
    }
    streams.push_back(
        {{"stream", i + 1}, {"topic", file_.tables[i].topic}, {"kind", "row"}, {"columns", std::move(columns)}});
  }
  if (movers_ != nullptr) {
    streams.push_back({{"stream", file_.tables.size() + 1},
                       {"topic", "/movers"},
                       {"kind", name_of(SampleKind::Movers)},
                       {"columns", Json::array()}});
  }
  for (std::size_t i = 0; i < exhibits_.size(); ++i) {
    const ExhibitTrack& track = exhibits_[i];
    streams.push_back({{"stream", stream_of(i)},
                       {"topic", exhibit_topic(track.owner, track.form, track.name)},
                       {"kind", name_of(track.form == "field" ? SampleKind::Field : SampleKind::Exhibit)},
                       {"columns", Json::array()},
                       {"of", whose_json(track)}});
  }
  return {{"info", latest_of(file_, "/run")}, {"scene", latest_of(file_, "/scene")}, {"streams", std::move(streams)},
          {"events", events_of(file_)},       {"duration_s", duration_s()},          {"tick_s", file_.info.tick_s},
          {"damages", std::move(damages)}};
}

std::string RecordingView::samples(double from_s, double to_s, std::size_t every) const {
  std::vector<Timed> samples;
  if (movers_ != nullptr) {
    add_movers(*movers_, static_cast<std::uint16_t>(file_.tables.size() + 1), from_s, to_s, samples);
  }
  for (std::size_t i = 0; i < exhibits_.size(); ++i) {
    const auto add = exhibits_[i].form == "field" ? add_field : add_exhibit;
    add(exhibits_[i], stream_of(i), from_s, to_s, samples);
  }
  for (std::size_t i = 0; i < file_.tables.size(); ++i) {
    add_rows(file_.tables[i], static_cast<std::uint16_t>(i + 1), from_s, to_s, std::max<std::size_t>(1, every),
             samples);
  }
  std::stable_sort(samples.begin(), samples.end(), [](const Timed& a, const Timed& b) { return a.time_s < b.time_s; });
  std::string bytes;
  for (const Timed& sample : samples) {
    const auto size = static_cast<std::uint32_t>(sample.bytes.size());
    char length[4];
    std::memcpy(length, &size, sizeof length);
    bytes.append(length, sizeof length);
    bytes += sample.bytes;
  }
  return bytes;
}

std::string RecordingView::controller() const {
  const mcap::Attachment* manifest = file_.attachment("inputs.json");
  const Json inputs = manifest != nullptr ? parsed(manifest->bytes) : Json();
  if (!inputs.is_object() || !inputs.contains("controller") || !inputs["controller"].is_string()) return "";
  const mcap::Attachment* text = file_.attachment("input/" + inputs["controller"].get<std::string>());
  return text != nullptr ? std::string(text->bytes) : std::string();
}

}  // namespace ganglion::studio
