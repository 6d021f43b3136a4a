#include "ganglion/report/player_exhibits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ganglion/record/exhibit/exhibit_json.h"
#include "ganglion/report/field_states.h"
#include "ganglion/report/packed.h"

namespace ganglion::report {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostStates = 300;    // of one curve, set of bars, network or frame
constexpr std::size_t kMostShapes = 20000;  // of one set of marks, through all of the run
constexpr std::size_t kMostExhibits = 200;
constexpr std::size_t kMostColumns = 200;

Json to_ms(double value) { return std::isfinite(value) ? Json(std::round(value * 1000) / 1000) : Json(nullptr); }
Json words(const Sentence& said) { return {{"en", said.en}, {"es", said.es}}; }

Json cells_json(const std::vector<std::vector<std::uint8_t>>& layers) {
  Json list = Json::array();
  for (const auto& cells : layers) list.push_back(pack_u8(run_lengths(cells)));
  return list;
}

Json field_json(const ExhibitTrack& track) {
  const FieldStates states = states_of(track);
  if (states.states.empty()) return nullptr;
  Json json = json_of(shown::Exhibit{{}, std::get<shown::Field>(states.states.front().change)});
  Json list = Json::array();
  for (const FieldStates::State& state : states.states) {
    if (const auto* field = std::get_if<shown::Field>(&state.change)) {
      list.push_back({{"t", to_ms(state.time_s)},
                      {"x", field->origin.x},
                      {"y", field->origin.y},
                      {"columns", field->columns},
                      {"rows", field->rows},
                      {"cells", cells_json(field->cells)}});
    } else {
      const auto& patch = std::get<shown::Patch>(state.change);
      list.push_back({{"t", to_ms(state.time_s)},
                      {"at", {patch.column, patch.row}},
                      {"columns", patch.columns},
                      {"rows", patch.rows},
                      {"cells", cells_json(patch.cells)}});
    }
  }
  json["states"] = std::move(list);
  return json;
}

/// Each shape once, with the times between which it was there; what lasts stays until something takes its place.
class Spans {
 public:
  void add(double time_s, const shown::Marks& marks) {
    std::multimap<std::string, std::size_t> still;
    for (const shown::Shape& shape : marks.shapes) take(time_s, shape, still);
    for (const auto& [key, index] : open_) {
      const Span& span = spans_[index];
      if (look_of(span.shape->role).lasts) {
        still.emplace(key, index);
      } else {
        spans_[index].until_s = time_s;
      }
    }
    open_ = std::move(still);
  }

  Json json() const {
    Json list = Json::array();
    for (const Span& span : spans_) {
      Json one = json_of(*span.shape);
      one["t"] = to_ms(span.from_s);
      if (std::isfinite(span.until_s)) one["until"] = to_ms(span.until_s);
      list.push_back(std::move(one));
    }
    return list;
  }

 private:
  struct Span {
    const shown::Shape* shape;
    double from_s;
    double until_s = std::numeric_limits<double>::infinity();
  };

  /// By id where it has one, else by where it is.
  static std::string key_of(const shown::Shape& shape) {
    if (!shape.id.empty()) return shape.id;
    return fmt::format("{} {} {} {}", static_cast<int>(shape.form), shape.frame, shape.points.front().x,
                       shape.points.front().y);
  }

  void take(double time_s, const shown::Shape& shape, std::multimap<std::string, std::size_t>& still) {
    const std::string key = key_of(shape);
    const auto [begin, end] = open_.equal_range(key);
    const auto same = std::find_if(begin, end, [&](const auto& entry) { return *spans_[entry.second].shape == shape; });
    if (same != end) {
      still.emplace(*same);
      open_.erase(same);
      return;
    }
    if (!shape.id.empty() && begin != end) {
      spans_[begin->second].until_s = time_s;
      open_.erase(begin);
    }
    if (spans_.size() >= kMostShapes) return;
    still.emplace(key, spans_.size());
    spans_.push_back({&shape, time_s});
  }

  std::vector<Span> spans_;
  std::multimap<std::string, std::size_t> open_;
};

Json marks_json(const ExhibitTrack& track) {
  Spans spans;
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    if (const auto* marks = std::get_if<shown::Marks>(&track.states[i].form)) spans.add(track.times_s[i], *marks);
  }
  return {{"shapes", spans.json()}};
}

Json states_json(const ExhibitTrack& track) {
  const std::size_t every = (track.states.size() + kMostStates - 1) / kMostStates;
  Json list = Json::array();
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    if (i % every != 0 && i + 1 != track.states.size()) continue;
    Json state = json_of(track.states[i]);
    state["t"] = to_ms(track.times_s[i]);
    list.push_back(std::move(state));
  }
  return {{"states", std::move(list)}};
}

Json exhibit_json(const ExhibitTrack& track) {
  Json json = track.form == "field"   ? field_json(track)
              : track.form == "marks" ? marks_json(track)
                                      : states_json(track);
  if (!json.is_object()) return nullptr;
  json["of"] = track.form;
  json["robot"] = track.owner.robot;
  json["owner"] = track.owner.name;
  json["name"] = track.name;
  json["title"] = words(track.title());
  return json;
}

}  // namespace

std::string roles_style() {
  std::string light, dark;
  for (const RoleLook& look : role_looks()) {
    light += fmt::format("--role-{}: #{:06x};", look.name, look.light);
    dark += fmt::format("--role-{}: #{:06x};", look.name, look.dark);
  }
  return fmt::format("<style>:root {{{}}} @media (prefers-color-scheme: dark) {{:root {{{}}}}}</style>\n", light, dark);
}

Json exhibits_json(const plot::RunView& run) {
  Json list = Json::array();
  for (const ExhibitTrack& track : run.exhibits) {
    if (list.size() >= kMostExhibits) break;
    if (Json one = exhibit_json(track); !one.is_null()) list.push_back(std::move(one));
  }
  return list;
}

std::vector<std::string> columns_needed(const plot::RunView& run, int robot) {
  std::set<std::string> names;
  const auto need = [&](const ExhibitTrack& track, const std::string& column) {
    const std::string prefix = fmt::format("robot{}/", robot);
    if (column.starts_with(prefix)) names.insert(column.substr(prefix.size()));
    if (!column.empty() && std::max(0, track.owner.robot) == robot) names.insert(column);
  };
  for (const ExhibitTrack& track : run.exhibits) {
    for (const shown::Exhibit& state : track.states) {
      if (names.size() >= kMostColumns) break;
      if (const auto* frame = std::get_if<shown::Frame>(&state.form)) {
        for (const std::string& column : {frame->x_m, frame->y_m, frame->yaw_rad}) need(track, column);
      }
      if (const auto* curve = std::get_if<shown::Curve>(&state.form)) need(track, curve->cursor);
      if (const auto* marks = std::get_if<shown::Marks>(&state.form)) {
        for (const shown::Shape& shape : marks->shapes) need(track, shape.radius);
      }
    }
  }
  std::erase_if(names, [&](const std::string& name) {
    return !run.robots[static_cast<std::size_t>(robot)].signals.find(name).has_value();
  });
  return {names.begin(), names.end()};
}

}  // namespace ganglion::report
