#include "ganglion/run/interference.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/base/expects.h"
#include "ganglion/base/text.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

/// What the digest knows of one: which it is, who is concerned, its arguments. A name goes in two halves, which a double
/// holds.
std::vector<double> numbers_of(const InterventionDescriptor& descriptor, const Intervention& what) {
  std::vector<double> numbers = {static_cast<double>(descriptor.code), static_cast<double>(what.robot), 0};
  if (!descriptor.subject.empty()) {
    const std::uint64_t name = hash_name(what.subject);
    numbers[1] = static_cast<double>(name >> 32);
    numbers[2] = static_cast<double>(name & 0xffffffffu);
  }
  for (const InterventionArgument& argument : descriptor.arguments) {
    numbers.push_back(what.argument(argument.name).value_or(0));
  }
  return numbers;
}

std::optional<double> number_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  const bool good = found != json.end() && found->is_number() && std::isfinite(found->get<double>());
  return good ? std::optional(found->get<double>()) : std::nullopt;
}

/// Numbers are arguments and a text is what it took hold of in place of a robot, whatever they are called: the
/// application judges them.
std::optional<TimedIntervention> read(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto tick = number_in(json, "tick");
  if (!tick || !(*tick >= 0 && *tick <= 4e9)) return std::nullopt;
  if (!json.contains("what") || !json["what"].is_string()) return std::nullopt;
  TimedIntervention one{static_cast<std::uint32_t>(*tick), {.name = json["what"].get<std::string>()}};
  for (const auto& [key, value] : json.items()) {
    if (key == "tick" || key == "what") continue;
    if (key == "robot") {
      const auto robot = number_in(json, "robot");
      if (!robot || !(*robot >= 0 && *robot <= 1e6)) return std::nullopt;
      one.what.robot = static_cast<int>(*robot);
    } else if (value.is_string()) {
      one.what.subject = value.get<std::string>();
    } else if (const auto number = number_in(json, key.c_str())) {
      one.what.arguments.push_back({key, *number});
    } else {
      return std::nullopt;
    }
  }
  if (json.contains("robot") == !one.what.subject.empty()) return std::nullopt;
  return one;
}

}  // namespace

std::string intervention_json(const InterventionDescriptor& descriptor, const TimedIntervention& one) {
  Json json = {{"tick", one.tick}, {"what", descriptor.name}};
  if (descriptor.subject.empty()) {
    json["robot"] = one.what.robot;
  } else {
    json[std::string(descriptor.subject)] = one.what.subject;
  }
  for (const NamedNumber& argument : one.what.arguments) json[argument.name] = argument.value;
  return json.dump();
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

Interference::Interference(Application* application, std::vector<TimedIntervention> planned, Told told)
    : application_(application), planned_(std::move(planned)), told_(std::move(told)) {}

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

Result<Intervened> Interference::reach(const Intervention& what) {
  if (application_ == nullptr) {
    return fail(
        ErrorCode::Unsupported,
        {"the robots are at the other end of a link; goals and obstacles can only be set in a world that is "
         "simulated here",
         "los robots están al otro extremo de un enlace; solo se pueden fijar objetivos y obstáculos en un mundo "
         "simulado aquí"});
  }
  auto done = application_->intervene(what);
  if (!done) return done;
  const InterventionDescriptor* descriptor = find(application_->interventions(), what.name);
  expects(descriptor != nullptr);  // what it does not list it does not do
  if (count_++ == 0) digest_.join(0, "@interventions");
  digest_.add(0, tick_, numbers_of(*descriptor, what));
  told_(*descriptor, {tick_, what});
  return done;
}

}  // namespace ganglion
