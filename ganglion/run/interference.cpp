#include "ganglion/run/interference.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

/// What the digest knows of one: kind, who is concerned, where.
std::array<double, 5> numbers_of(const sim::Intervention& what) {
  if (const auto* goal = std::get_if<sim::SetGoal>(&what)) {
    return {0, static_cast<double>(goal->robot), 0, goal->point.x, goal->point.y};
  }
  const auto& put = std::get<sim::PutMover>(what);
  const std::uint64_t name = hash_name(put.mover);  // in two halves, which a double holds
  return {1, static_cast<double>(name >> 32), static_cast<double>(name & 0xffffffffu), put.point.x, put.point.y};
}

std::optional<double> number_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  const bool good = found != json.end() && found->is_number() && std::isfinite(found->get<double>());
  return good ? std::optional(found->get<double>()) : std::nullopt;
}

std::optional<TimedIntervention> read(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto tick = number_in(json, "tick"), x = number_in(json, "x_m"), y = number_in(json, "y_m");
  if (!tick || !(*tick >= 0 && *tick <= 4e9) || !x || !y) return std::nullopt;
  const auto whole_tick = static_cast<std::uint32_t>(*tick);
  const std::string what = json.contains("what") && json["what"].is_string() ? json["what"].get<std::string>() : "";
  if (what == "goal") {
    const auto robot = number_in(json, "robot");
    if (!robot || !(*robot >= 0 && *robot <= 1e6)) return std::nullopt;
    return TimedIntervention{whole_tick, sim::SetGoal{static_cast<int>(*robot), {*x, *y}}};
  }
  if (what != "obstacle" || !json.contains("mover") || !json["mover"].is_string()) return std::nullopt;
  return TimedIntervention{whole_tick, sim::PutMover{json["mover"].get<std::string>(), {*x, *y}}};
}

}  // namespace

std::string intervention_json(const TimedIntervention& one) {
  Json json = {{"tick", one.tick}};
  if (const auto* goal = std::get_if<sim::SetGoal>(&one.what)) {
    json.update({{"what", "goal"}, {"robot", goal->robot}, {"x_m", goal->point.x}, {"y_m", goal->point.y}});
  } else {
    const auto& put = std::get<sim::PutMover>(one.what);
    json.update({{"what", "obstacle"}, {"mover", put.mover}, {"x_m", put.point.x}, {"y_m", put.point.y}});
  }
  return json.dump();
}

Sentence intervention_text(const TimedIntervention& one) {
  if (const auto* goal = std::get_if<sim::SetGoal>(&one.what)) {
    return say({"goal of robot {} set at ({:.2f}, {:.2f})", "objetivo del robot {} fijado en ({:.2f}, {:.2f})"},
               goal->robot, goal->point.x, goal->point.y);
  }
  const auto& put = std::get<sim::PutMover>(one.what);
  return say({"\"{}\" put at ({:.2f}, {:.2f})", "\"{}\" puesto en ({:.2f}, {:.2f})"}, put.mover, put.point.x,
             put.point.y);
}

Result<std::vector<TimedIntervention>> interventions_of(const RunFile& run) {
  std::vector<TimedIntervention> list;
  const auto topic = run.json.find(kInterventionTopic);
  if (topic == run.json.end()) return list;
  for (const JsonMessage& message : topic->second.messages) {
    auto one = read(message.text);
    if (!one || (!list.empty() && one->tick < list.back().tick)) {
      return fail(ErrorCode::Corrupt,
                  {"the run file's intervention {} at {} s cannot be made out",
                   "no se entiende la intervención {} del archivo de la ejecución, en {} s"},
                  list.size() + 1, shortest(message.time_s));
    }
    list.push_back(std::move(*one));
  }
  return list;
}

Interference::Interference(sim::Simulation* simulation, std::vector<TimedIntervention> planned, Told told)
    : simulation_(simulation), planned_(std::move(planned)), told_(std::move(told)) {}

Result<void> Interference::before(std::uint32_t tick) {
  tick_ = tick;
  while (next_ < planned_.size() && planned_[next_].tick <= tick) {
    const TimedIntervention& one = planned_[next_++];
    if (const auto done = reach(one.what); !done) {
      return fail(done.error().code,
                  {"what was to be done before tick {} cannot be: {}",
                   "lo que había que hacer antes del ciclo {} no se puede: {}"},
                  one.tick, done.error().what);
    }
  }
  return {};
}

Result<sim::Intervened> Interference::reach(const sim::Intervention& what) {
  if (simulation_ == nullptr) {
    return fail(
        ErrorCode::Unsupported,
        {"the robots are at the other end of a link; goals and obstacles can only be set in a world that is "
         "simulated here",
         "los robots están al otro extremo de un enlace; solo se pueden fijar objetivos y obstáculos en un mundo "
         "simulado aquí"});
  }
  auto done = simulation_->intervene(what);
  if (!done) return done;
  if (count_++ == 0) digest_.join(0, "@interventions");
  digest_.add(0, tick_, numbers_of(what));
  told_({tick_, what});
  return done;
}

}  // namespace ganglion
