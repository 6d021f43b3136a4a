#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ganglion/studio/live/feed.h"
#include "ganglion/studio/live/sample.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

/// What goes to a viewer next.
struct Outgoing {
  std::shared_ptr<const std::string> bytes;
  bool binary = false;
};

class Hub;

/// One onlooker. Events wait for him as long as the hub keeps them; of samples only the newest do.
class Viewer {
 public:
  /// `wake` is called when there may be something new; not from within next().
  Viewer(Hub& hub, std::function<void()> wake);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// He was here before: events after `seq` of that session, or everything anew. At most once, before next().
  void resume(const std::string& session, std::uint64_t seq);
  /// Rows that wait for him come in one message from now on: a hundred robots thirty times a second are otherwise three
  /// thousand messages, which cost a page more than what is in them.
  void bundle_rows() noexcept { bundles_ = true; }
  /// What to send now; none = nothing. False at lost(): he is so far behind that events are gone.
  std::optional<Outgoing> next();
  bool lost() const noexcept { return lost_; }

 private:
  friend class Hub;
  static constexpr std::size_t kRows = 256;
  static constexpr std::size_t kBundleBytes = 1 << 20;

  std::optional<Outgoing> next_state();
  Outgoing next_rows();

  Hub& hub_;
  std::function<void()> wake_;
  bool greeted_ = false;
  bool resumed_ = false;
  bool lost_ = false;
  bool bundles_ = false;
  std::uint64_t next_seq_ = 0;
  std::deque<std::shared_ptr<const std::string>> rows_;
  std::map<std::uint16_t, std::uint32_t> sent_;  ///< Of each map, route...: which state he has.
};

/// Brings what runs say to any number of viewers. Used by one thread.
class Hub {
 public:
  explicit Hub(std::string session) : session_(std::move(session)) {}

  /// The run to watch from now on; its streams are announced when it is armed.
  void watch(std::shared_ptr<LiveFeed> feed);
  /// Takes what the feed has. To be called again and again; true if there was something.
  bool drain();

  /// An event: a member "event" with its name, and whatever belongs to it.
  void event(const std::string& name, Json content);
  /// What hello says of the run; also an event.
  void set_state(Json state);
  const Json& state() const noexcept { return state_; }

 private:
  friend class Viewer;
  struct Event {
    std::uint64_t seq;
    std::shared_ptr<const std::string> text;
  };
  /// A stream of which only the newest state counts.
  struct Latest {
    SampleKind kind = SampleKind::Exhibit;
    std::uint32_t seq = 0;
    double time_s = 0;
    FieldState field;
    std::shared_ptr<const std::string> sample;  ///< Of anything but fields.
  };

  void announce();
  void take_rows();
  void take(LiveFeed::Message& message);
  void take_state(LiveFeed::Message& message, SampleKind kind);
  std::uint16_t stream_of(const std::string& topic, SampleKind kind);
  Json streams_json() const;
  std::string hello(bool resumed) const;
  void wake();

  std::string session_;
  std::uint64_t seq_ = 0;
  std::deque<Event> events_;
  std::size_t event_bytes_ = 0;
  std::vector<Viewer*> viewers_;
  std::shared_ptr<LiveFeed> feed_;
  bool announced_ = false;
  Json state_ = {{"state", "idle"}};
  Json scene_, info_;
  std::map<std::string, std::uint16_t> streams_;  ///< By topic.
  std::map<std::uint16_t, Latest> latest_;
};

}  // namespace ganglion::studio
