#include "ganglion/studio/live/hub.h"

#include <algorithm>

#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/studio/live/messages.h"

namespace ganglion::studio {
namespace {

constexpr std::size_t kEvents = 20'000;  // kept for viewers that come back
constexpr std::size_t kEventBytes = std::size_t{64} << 20;
constexpr std::size_t kRowsAtOnce = 4;  // of a stream, of all that came since the last look

}  // namespace

Viewer::Viewer(Hub& hub, std::function<void()> wake) : hub_(hub), wake_(std::move(wake)), next_seq_(hub.seq_ + 1) {
  hub.viewers_.push_back(this);
}

Viewer::~Viewer() { std::erase(hub_.viewers_, this); }

void Viewer::resume(const std::string& session, std::uint64_t seq) {
  if (greeted_ || session != hub_.session_ || seq > hub_.seq_) return;
  const std::uint64_t oldest = hub_.events_.empty() ? hub_.seq_ + 1 : hub_.events_.front().seq;
  if (seq + 1 < oldest) return;
  next_seq_ = seq + 1;
  resumed_ = true;
}

std::optional<Outgoing> Viewer::next() {
  if (!greeted_) {
    greeted_ = true;
    if (!resumed_) next_seq_ = hub_.seq_ + 1;
    return Outgoing{std::make_shared<const std::string>(hub_.hello(resumed_)), false};
  }
  if (next_seq_ <= hub_.seq_) {
    if (next_seq_ < hub_.events_.front().seq) {
      lost_ = true;
      return std::nullopt;
    }
    const Hub::Event& event = hub_.events_[next_seq_ - hub_.events_.front().seq];
    ++next_seq_;
    return Outgoing{event.text, false};
  }
  if (auto state = next_state()) return state;
  if (rows_.empty()) return std::nullopt;
  return next_rows();
}

Outgoing Viewer::next_rows() {
  std::vector<std::shared_ptr<const std::string>> rows;
  std::size_t bytes = 0;
  do {
    bytes += rows_.front()->size();
    rows.push_back(std::move(rows_.front()));
    rows_.pop_front();
  } while (bundles_ && !rows_.empty() && bytes + rows_.front()->size() <= kBundleBytes);
  if (rows.size() == 1) return {std::move(rows.front()), true};
  return {std::make_shared<const std::string>(bundle_sample(rows)), true};
}

/// A field, mover or whatever is shown that he has an older state of.
std::optional<Outgoing> Viewer::next_state() {
  for (const auto& [stream, latest] : hub_.latest_) {
    std::uint32_t& has = sent_[stream];
    if (has == latest.seq) continue;
    const std::uint32_t base = has;
    has = latest.seq;
    if (latest.kind != SampleKind::Field) return Outgoing{latest.sample, true};
    const SampleHead head{stream, latest.seq, latest.time_s};
    return Outgoing{std::make_shared<const std::string>(latest.field.sample(head, base)), true};
  }
  return std::nullopt;
}

void Hub::watch(std::shared_ptr<LiveFeed> feed) {
  feed_ = std::move(feed);
  announced_ = false;
  scene_ = info_ = nullptr;
}

bool Hub::drain() {
  if (!feed_ || !feed_->armed()) return false;
  bool fresh = !announced_;
  if (!announced_) announce();
  for (int most = 1000; most > 0 && feed_->message() != nullptr; --most) {
    take(*feed_->message());
    feed_->pop_message();
    fresh = true;
  }
  if (feed_->row() != nullptr) {
    take_rows();
    fresh = true;
  }
  if (fresh) wake();
  return fresh;
}

/// A new run: what was known of the old is forgotten before its first sample.
void Hub::announce() {
  announced_ = true;
  streams_.clear();
  latest_.clear();
  scene_ = info_ = nullptr;
  for (Viewer* viewer : viewers_) {
    viewer->rows_.clear();
    viewer->sent_.clear();
  }
  for (const StreamInfo& table : feed_->tables()) stream_of(table.topic, SampleKind::Row);
  while (LiveFeed::Message* message = feed_->message()) {
    if (message->topic != "/scene" && message->topic != "/run") break;
    (message->topic == "/scene" ? scene_ : info_) = parsed(message->json);
    feed_->pop_message();
  }
  event("streams", {{"streams", streams_json()}, {"scene", scene_}, {"info", info_}});
}

void Hub::take_rows() {
  std::map<int, std::deque<std::shared_ptr<const std::string>>> newest;
  for (int most = 20'000; most > 0 && feed_->row() != nullptr; --most) {
    const LiveFeed::Row& row = *feed_->row();
    auto& of_table = newest[row.table];
    const SampleHead head{static_cast<std::uint16_t>(row.table + 1), row.seq, row.time_s};
    of_table.push_back(
        std::make_shared<const std::string>(row_sample(head, row.tick, std::span(row.values).first(row.count))));
    if (of_table.size() > kRowsAtOnce) of_table.pop_front();
    feed_->pop_row();
  }
  const std::size_t room = std::max(Viewer::kRows, 4 * feed_->tables().size());
  for (Viewer* viewer : viewers_) {
    for (const auto& [table, rows] : newest) viewer->rows_.insert(viewer->rows_.end(), rows.begin(), rows.end());
    while (viewer->rows_.size() > room) viewer->rows_.pop_front();
  }
}

void Hub::take(LiveFeed::Message& message) {
  if (const auto kind = sample_kind_of(message.topic, message.schema)) {
    take_state(message, *kind);
  } else if (auto told = event_of(message.schema, message.time_s, message.json)) {
    event(told->name, std::move(told->content));
  }
}

void Hub::take_state(LiveFeed::Message& message, SampleKind kind) {
  const std::uint16_t stream = stream_of(message.topic, kind);
  Latest& latest = latest_[stream];
  latest.kind = kind;
  const SampleHead head{stream, latest.seq + 1, message.time_s};
  if (kind != SampleKind::Movers) {
    const auto exhibit = decode_exhibit(message.json);
    if (!exhibit || (kind == SampleKind::Field && !latest.field.take(*exhibit, head.seq))) return;
    if (kind == SampleKind::Exhibit)
      latest.sample = std::make_shared<const std::string>(exhibit_sample(head, *exhibit));
  } else {
    latest.sample = std::make_shared<const std::string>(movers_sample(head, message.json));
  }
  latest.seq = head.seq;
  latest.time_s = message.time_s;
}

std::uint16_t Hub::stream_of(const std::string& topic, SampleKind kind) {
  const auto [found, fresh] = streams_.try_emplace(topic, static_cast<std::uint16_t>(streams_.size() + 1));
  if (fresh && announced_ && kind != SampleKind::Row) {
    latest_[found->second].kind = kind;
    event("streams", {{"streams", streams_json()}, {"more", true}});
  }
  return found->second;
}

Json Hub::streams_json() const {
  Json list = Json::array();
  std::map<std::uint16_t, std::string> by_number;
  for (const auto& [topic, stream] : streams_) by_number[stream] = topic;
  for (const auto& [stream, topic] : by_number) {
    Json one = {{"stream", stream}, {"topic", topic}, {"kind", "row"}};
    one["columns"] = Json::array();
    if (stream <= feed_->tables().size()) {
      for (const SignalColumn& column : feed_->tables()[stream - 1].columns) {
        one["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
      }
    } else if (const auto latest = latest_.find(stream); latest != latest_.end()) {
      one["kind"] = name_of(latest->second.kind);
      if (const auto track = track_of(topic)) one["of"] = whose_json(*track);
    }
    list.push_back(std::move(one));
  }
  return list;
}

std::string Hub::hello(bool resumed) const {
  return dumped({{"type", "hello"},
                 {"protocol", 1},
                 {"session", session_},
                 {"seq", seq_},
                 {"resumed", resumed},
                 {"state", state_},
                 {"streams", announced_ ? streams_json() : Json::array()},
                 {"scene", scene_},
                 {"info", info_}});
}

void Hub::event(const std::string& name, Json content) {
  Json json = {{"type", "event"}, {"seq", ++seq_}, {"event", name}};
  json.update(content);
  events_.push_back({seq_, std::make_shared<const std::string>(dumped(json))});
  event_bytes_ += events_.back().text->size();
  while (events_.size() > kEvents || (event_bytes_ > kEventBytes && events_.size() > 1)) {
    event_bytes_ -= events_.front().text->size();
    events_.pop_front();
  }
  wake();
}

void Hub::set_state(Json state) {
  state_ = std::move(state);
  event("run", {{"state", state_}});
}

void Hub::wake() {
  for (Viewer* viewer : viewers_) viewer->wake_();
}

}  // namespace ganglion::studio
