#include "ganglion/application/fault/fault.h"

#include <cmath>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

/// What a target's name stands for.
struct Signals {
  bool commands = false;
  std::vector<std::size_t> values;
  std::vector<std::size_t> channels;
  void add(int offset, int size, std::size_t channel) {
    for (int n = 0; n < size; ++n) values.push_back(static_cast<std::size_t>(offset + n));
    channels.push_back(channel);
  }
};

Signals sensations_named(std::string_view target, const Description& robot) {
  Signals signals;
  for (std::size_t c = 0; c < robot.sensations.size(); ++c) {
    const std::string& name = robot.sensations[c].name;
    const std::string_view device = std::string_view(name).substr(0, name.find('.'));
    if (target != "frames" && target != name && target != device) continue;
    signals.add(robot.sensation_offset(c), robot.sensations[c].size(), c);
  }
  return signals;
}

Signals commands_named(std::string_view target, const Description& robot) {
  Signals signals{.commands = true, .values = {}, .channels = {}};
  for (std::size_t c = 0; c < robot.commands.size(); ++c) {
    const CommandChannel& command = robot.commands[c];
    const int size = static_cast<int>(command.elements.size());
    if (target == "commands" || target == command.name) signals.add(robot.command_offset(c), size, c);
    for (int n = 0; n < size; ++n) {
      if (target == command.name + "." + command.elements[static_cast<std::size_t>(n)].name)
        signals.add(robot.command_offset(c) + n, 1, c);
    }
  }
  return signals;
}

std::vector<std::string> known_targets(const Description& robot) {
  std::vector<std::string> names = {"frames", "commands"};
  for (const SensationChannel& channel : robot.sensations) {
    const std::string device = channel.name.substr(0, channel.name.find('.'));
    if (names.back() != device) names.push_back(device);
    names.push_back(channel.name);
  }
  for (const CommandChannel& command : robot.commands) {
    names.push_back(command.name);
    for (const CommandElement& element : command.elements) names.push_back(command.name + "." + element.name);
  }
  return names;
}

Result<Signals> signals_named(const std::string& target, const Fault& fault, const Description& robot) {
  Signals signals = sensations_named(target, robot);
  if (signals.values.empty()) signals = commands_named(target, robot);
  if (!signals.values.empty()) return signals;
  auto targets = known_targets(robot);
  Sentence what = say(
      {"\"{}\" is no sensor, channel or command of the robot{}", "\"{}\" no es un sensor, canal ni mando del robot{}"},
      target, suggestion(target, targets));
  return tl::unexpected<Error>(
      Error{ErrorCode::UnknownKey, std::move(what), fault.place, {.found = target, .choices = std::move(targets)}});
}

/// What is wrong with the amount, or "".
Text complaint_on(const Fault& fault) {
  constexpr Text kNone{"", ""};
  const double a = fault.amount;
  if (!std::isfinite(a)) return {"amount must be a finite number", "amount debe ser un número finito"};
  switch (fault.kind) {
    case FaultKind::Noisy:
      return a > 0 ? kNone
                   : Text{"amount is the noise's standard deviation, must be > 0",
                          "amount es la desviación típica del ruido, debe ser > 0"};
    case FaultKind::Late:
      return a > 0 && a <= 60 ? kNone
                              : Text{"amount is the delay in seconds, must be > 0 and at most 60",
                                     "amount es el retraso en segundos, debe ser > 0 y como máximo 60"};
    case FaultKind::Weak:
      return a > 0 && a <= 1 ? kNone
                             : Text{"amount is the share that is lost, must be > 0 and at most 1",
                                    "amount es la parte que se pierde, debe ser > 0 y como máximo 1"};
    case FaultKind::Lost:
      return a > 0 && a <= 1 ? kNone
                             : Text{"amount is a probability, must be > 0 and at most 1",
                                    "amount es una probabilidad, debe ser > 0 y como máximo 1"};
    case FaultKind::Biased:
      return a != 0 ? kNone : Text{"amount is what is added, must not be 0", "amount es lo que se suma, no debe ser 0"};
    default:
      return kNone;
  }
}

}  // namespace

std::string Fault::text() const {
  std::string text = target + " " + std::string(kFaultNames[static_cast<std::size_t>(kind)]);
  if (!with.empty()) return text + " with " + with;
  return amount != 0 ? text + fmt::format(" {:.3g}", amount) : text;
}

Result<FaultSite> site_of(const Fault& fault, const Description& robot) {
  if (const Text complaint = complaint_on(fault); !complaint.empty())
    return fail_at(fault.place, ErrorCode::BadParameter, {"{}", "{}"}, complaint);
  auto signals = signals_named(fault.target, fault, robot);
  if (!signals) return tl::unexpected<Error>(signals.error());
  if (fault.kind == FaultKind::Weak && !signals->commands)
    return fail_at(
        fault.place, ErrorCode::BadParameter,
        {"only commands grow weak; \"{}\" is a sensation", "solo los mandos se debilitan; \"{}\" es una sensación"},
        fault.target);
  FaultSite site{signals->commands, std::move(signals->values), std::move(signals->channels), {}};
  if (fault.kind != FaultKind::Swapped) return site;
  auto others = signals_named(fault.with, fault, robot);
  if (!others) return tl::unexpected<Error>(others.error());
  if (others->commands != site.commands || others->values.size() != site.values.size() || others->values == site.values)
    return fail_at(fault.place, ErrorCode::BadParameter,
                   {"\"{}\" and \"{}\" cannot be swapped: they differ in shape",
                    "\"{}\" y \"{}\" no se pueden intercambiar: difieren en forma"},
                   fault.target, fault.with);
  site.with_values = std::move(others->values);
  return site;
}

}  // namespace ganglion
