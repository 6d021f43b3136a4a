#include "ganglion/link/wire/description.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ganglion/base/text.h"
#include "ganglion/link/wire/framing.h"

namespace ganglion::link {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

void write_sensation(const SensationChannel& channel, const Mount* mount, wire::Sensation& out) {
  out.set_name(channel.name);
  out.set_unit(channel.unit);
  out.set_type(static_cast<wire::ValueType>(channel.type));
  for (const std::string& element : channel.elements) out.add_elements(element);
  if (channel.min > -kInf) out.set_min(channel.min);
  if (channel.max < kInf) out.set_max(channel.max);
  out.set_period_s(channel.period_s);
  if (mount != nullptr) {
    out.set_x_m(mount->pose.position.x);
    out.set_y_m(mount->pose.position.y);
    out.set_yaw_rad(mount->pose.yaw.rad());
  }
  if (!std::isnan(channel.dead)) out.set_dead(channel.dead);
}

/// Its size stands twice, for controllers that know version 1.0 only.
void write_body(const Body& body, wire::Describe& out) {
  out.set_length_m(body.length_m);
  out.set_width_m(body.width_m);
  if (body.radius_m == 0 && body.mounts.empty()) return;
  wire::Body& message = *out.mutable_body();
  message.set_length_m(body.length_m);
  message.set_width_m(body.width_m);
  message.set_radius_m(body.radius_m);
  for (const Mount& mount : body.mounts) {
    wire::Mount& one = *message.add_mounts();
    one.set_device(mount.device);
    one.set_kind(mount.kind);
    one.set_x_m(mount.pose.position.x);
    one.set_y_m(mount.pose.position.y);
    one.set_yaw_rad(mount.pose.yaw.rad());
    one.set_cone_rad(mount.cone_rad);
    one.set_max_range_m(mount.max_range_m);
  }
}

/// As a robot of version 1.0 has it: a size, and a place for each sensation.
std::optional<Body> read_old_body(const wire::Describe& message) {
  if (message.length_m() == 0 && message.width_m() == 0) return std::nullopt;
  Body body{message.length_m(), message.width_m(), 0, {}};
  for (const wire::Sensation& one : message.sensations()) {
    body.mounts.push_back({one.name(), "", {{one.x_m(), one.y_m()}, Angle::from_rad(one.yaw_rad())}, 0, 0});
  }
  return body;
}

Result<std::optional<Body>> read_body(const wire::Describe& message) {
  if (!(message.length_m() >= 0 && message.width_m() >= 0)) {
    return fail(ErrorCode::BadParameter, {"length_m and width_m must be >= 0", "length_m y width_m deben ser >= 0"});
  }
  if (!message.has_body()) return read_old_body(message);
  const wire::Body& told = message.body();
  bool good = told.length_m() >= 0 && told.width_m() >= 0 && told.radius_m() >= 0;
  good = good && told.mounts_size() <= kMaxChannels;
  Body body{told.length_m(), told.width_m(), told.radius_m(), {}};
  for (const wire::Mount& one : told.mounts()) {
    good = good && std::isfinite(one.x_m() + one.y_m() + one.yaw_rad() + one.cone_rad() + one.max_range_m()) &&
           one.device().size() <= kMaxNameBytes && one.kind().size() <= kMaxNameBytes;
    if (!good) break;
    body.mounts.push_back({one.device(),
                           one.kind(),
                           {{one.x_m(), one.y_m()}, Angle::from_rad(one.yaw_rad())},
                           one.cone_rad(),
                           one.max_range_m()});
  }
  if (!good) {
    return fail(ErrorCode::BadParameter,
                {"the body's size must be >= 0, and its at most {} devices at finite places",
                 "el tamaño del cuerpo debe ser >= 0, y sus dispositivos, {} como máximo, en lugares finitos"},
                kMaxChannels);
  }
  return std::optional<Body>(std::move(body));
}

bool good_name(const std::string& name) noexcept { return !name.empty() && name.size() <= kMaxNameBytes; }

Result<SensationChannel> read_sensation(const wire::Sensation& message) {
  const std::string name = printable(message.name(), kMaxNameBytes);
  SensationChannel channel;
  channel.name = message.name();
  channel.unit = message.unit();
  if (channel.unit.size() > kMaxNameBytes || message.elements_size() > kMaxElements) {
    return fail(ErrorCode::TooLarge,
                {"sensation \"{}\": at most {} elements, and {} bytes of unit",
                 "sensación \"{}\": como máximo {} elementos, y {} bytes de unidad"},
                name, kMaxElements, kMaxNameBytes);
  }
  if (!wire::ValueType_IsValid(message.type())) {
    return fail(ErrorCode::BadParameter,
                {"sensation \"{}\": no such type: {}", "sensación \"{}\": no existe ese tipo: {}"}, name,
                static_cast<int>(message.type()));
  }
  channel.type = static_cast<ValueType>(message.type());
  channel.elements.assign(message.elements().begin(), message.elements().end());
  channel.min = message.has_min() ? message.min() : -kInf;
  channel.max = message.has_max() ? message.max() : kInf;
  channel.period_s = message.period_s();
  if (message.has_dead()) channel.dead = message.dead();
  const bool finite = std::isfinite(message.x_m()) && std::isfinite(message.y_m()) && std::isfinite(message.yaw_rad());
  if (!finite || !(channel.min <= channel.max) || !(channel.period_s >= 0)) {
    return fail(ErrorCode::BadParameter,
                {"sensation \"{}\": min must be <= max, period_s >= 0, and its place on the body finite",
                 "sensación \"{}\": min debe ser <= max, period_s >= 0, y su lugar en el cuerpo finito"},
                name);
  }
  return channel;
}

Result<CommandChannel> read_command(const wire::Command& message) {
  const std::string name = printable(message.name(), kMaxNameBytes);
  if (message.elements_size() < 1 || message.elements_size() > kMaxElements) {
    return fail(ErrorCode::BadParameter,
                {"command \"{}\": 1 to {} elements, not {}", "mando \"{}\": de 1 a {} elementos, no {}"}, name,
                kMaxElements, message.elements_size());
  }
  CommandChannel channel{message.name(), {}};
  for (const wire::CommandElement& one : message.elements()) {
    const bool finite = std::isfinite(one.min()) && std::isfinite(one.max());
    if (!finite || !(one.min() <= one.safe() && one.safe() <= one.max())) {
      return fail(ErrorCode::BadParameter,
                  {"command \"{}\", element \"{}\": min <= safe <= max must hold, all finite",
                   "mando \"{}\", elemento \"{}\": debe cumplirse min <= safe <= max, todos finitos"},
                  name, printable(one.name(), kMaxNameBytes));
    }
    channel.elements.push_back({one.name(), one.unit(), one.min(), one.max(), one.safe()});
  }
  return channel;
}

/// What a channel is called; one of them, and many.
struct Called {
  Text one, many;
};

template <class Read, class List, class Into>
Result<void> read_channels(const Called& what, const List& list, Read&& read, Into& into) {
  if (list.size() > kMaxChannels) {
    return fail(ErrorCode::TooLarge, {"{} {}; the limit is {}", "{} {}; el límite es {}"}, list.size(), what.many,
                kMaxChannels);
  }
  std::set<std::string> names;
  for (const auto& message : list) {
    if (!good_name(message.name()) || !names.insert(message.name()).second) {
      return fail(ErrorCode::BadParameter,
                  {"{} \"{}\": names have 1 to {} bytes and stand there once",
                   "{} \"{}\": los nombres tienen de 1 a {} bytes y aparecen una sola vez"},
                  what.one, printable(message.name(), kMaxNameBytes), kMaxNameBytes);
    }
    auto channel = read(message);
    if (!channel) return tl::unexpected<Error>(channel.error());
    into.push_back(std::move(*channel));
  }
  return {};
}

std::vector<std::string> element_names(const SensationChannel& channel) { return channel.elements; }
std::vector<std::string> element_names(const CommandChannel& channel) {
  std::vector<std::string> names;
  for (const CommandElement& element : channel.elements) names.push_back(element.name);
  return names;
}

std::vector<std::string> names_of(const auto& channels) {
  std::vector<std::string> names;
  for (const auto& channel : channels) names.push_back(channel.name);
  return names;
}

/// One list of differences as it grows.
class Comparison {
 public:
  void add(const std::string& channel, bool grave, Sentence text) {
    list_.push_back({channel, std::move(text), grave});
  }
  void text(const std::string& channel, const Sentence& what, const std::string& robot, const std::string& file) {
    if (robot == file) return;
    add(channel, true,
        say({"{}: the robot has \"{}\", the file \"{}\"", "{}: el robot tiene \"{}\", el archivo \"{}\""}, what, robot,
            file));
  }
  void number(const std::string& channel, const Sentence& what, double robot, double file) {
    if (robot == file || (std::isnan(robot) && std::isnan(file))) return;
    add(channel, false,
        say({"{}: the robot has {}, the file {}", "{}: el robot tiene {}, el archivo {}"}, what, shortest(robot),
            shortest(file)));
  }
  /// Of a key that has no name in words.
  void number(const std::string& channel, const char* key, double robot, double file) {
    number(channel, Sentence::quoted(key), robot, file);
  }
  /// The robot's channel of that name; null, and noted, where there is `such` none.
  template <class Channel>
  const Channel* partner(const Text& such, const Channel& file, const std::vector<Channel>& robot) {
    for (const Channel& channel : robot) {
      if (channel.name != file.name) continue;
      text(file.name, say({"elements", "elementos"}), join(element_names(channel)), join(element_names(file)));
      return &channel;
    }
    add(file.name, true,
        say({"the robot has {}{}", "el robot no tiene {}{}"}, such, suggestion(file.name, names_of(robot))));
    return nullptr;
  }
  std::vector<Difference> take() { return std::move(list_); }

 private:
  std::vector<Difference> list_;
};

Pose2 pose_of(const Mount* mount) noexcept { return mount != nullptr ? mount->pose : Pose2{}; }

void compare_sensations(const Description& file, const Description& robot, Comparison& found) {
  for (const SensationChannel& wanted : file.sensations) {
    const SensationChannel* offered = found.partner({"no such sensation", "esa sensación"}, wanted, robot.sensations);
    if (offered == nullptr) continue;
    found.text(wanted.name, say({"unit", "unidad"}), offered->unit, wanted.unit);
    found.text(wanted.name, say({"type", "tipo"}), std::string(name_of(offered->type)),
               std::string(name_of(wanted.type)));
    found.number(wanted.name, say({"min", "mínimo"}), offered->min, wanted.min);
    found.number(wanted.name, say({"max", "máximo"}), offered->max, wanted.max);
    found.number(wanted.name, "period_s", offered->period_s, wanted.period_s);
    const Pose2 there = pose_of(robot.mount(wanted.name)), here = pose_of(file.mount(wanted.name));
    found.number(wanted.name, "x_m", there.position.x, here.position.x);
    found.number(wanted.name, "y_m", there.position.y, here.position.y);
    found.number(wanted.name, "yaw_rad", there.yaw.rad(), here.yaw.rad());
  }
}

void compare_commands(const Description& file, const Description& robot, Comparison& found) {
  for (const CommandChannel& wanted : file.commands) {
    const CommandChannel* offered = found.partner({"no such command", "ese mando"}, wanted, robot.commands);
    if (offered == nullptr || offered->elements.size() != wanted.elements.size()) continue;
    for (std::size_t n = 0; n < wanted.elements.size(); ++n) {
      const CommandElement &mine = wanted.elements[n], &theirs = offered->elements[n];
      found.text(wanted.name, say({"unit of {}", "unidad de {}"}, mine.name), theirs.unit, mine.unit);
      found.number(wanted.name, say({"min of {}", "mínimo de {}"}, mine.name), theirs.min, mine.min);
      found.number(wanted.name, say({"max of {}", "máximo de {}"}, mine.name), theirs.max, mine.max);
      found.number(wanted.name, say({"safe value of {}", "valor seguro de {}"}, mine.name), theirs.safe, mine.safe);
    }
  }
}

}  // namespace

void write_description(const Description& description, wire::Describe& out) {
  out.set_name(description.name);
  out.set_tick_s(description.tick_s);
  if (description.body) write_body(*description.body, out);
  for (const SensationChannel& channel : description.sensations) {
    write_sensation(channel, description.mount(channel.name), *out.add_sensations());
  }
  for (const CommandChannel& channel : description.commands) {
    wire::Command& command = *out.add_commands();
    command.set_name(channel.name);
    for (const CommandElement& element : channel.elements) {
      wire::CommandElement& one = *command.add_elements();
      one.set_name(element.name);
      one.set_unit(element.unit);
      one.set_min(element.min);
      one.set_max(element.max);
      one.set_safe(element.safe);
    }
  }
}

Result<Description> read_description(const wire::Describe& message) {
  Description description;
  description.name = printable(message.name(), kMaxNameBytes);
  description.tick_s = message.tick_s();
  if (!(description.tick_s >= 1e-6 && description.tick_s <= 3600)) {
    return fail(ErrorCode::BadParameter,
                {"tick_s is {}, must lie in [1e-06, 3600] s", "tick_s es {}, debe estar en [1e-06, 3600] s"},
                shortest(message.tick_s()));
  }
  auto body = read_body(message);
  if (!body) return tl::unexpected<Error>(body.error());
  description.body = std::move(*body);
  if (message.robots() > kMaxRobots) {
    return fail(ErrorCode::TooLarge, {"{} robots; the limit is {}", "{} robots; el límite es {}"}, message.robots(),
                kMaxRobots);
  }
  constexpr Called kSensation = {{"sensation", "sensación"}, {"sensations", "sensaciones"}};
  constexpr Called kCommand = {{"command", "mando"}, {"commands", "mandos"}};
  if (auto read = read_channels(kSensation, message.sensations(), read_sensation, description.sensations); !read) {
    return tl::unexpected<Error>(read.error());
  }
  if (auto read = read_channels(kCommand, message.commands(), read_command, description.commands); !read) {
    return tl::unexpected<Error>(read.error());
  }
  const auto numbers = static_cast<std::size_t>(description.sensation_values()) + description.sensations.size();
  if (std::max<std::size_t>(1, message.robots()) * numbers * sizeof(double) > kMaxFrameBytes) {
    return fail(ErrorCode::TooLarge,
                {"a Sense of {} robots with {} values and ages each would take more than the {} bytes of a frame",
                 "un Sense de {} robots con {} valores y antigüedades cada uno pasaría de los {} bytes de una trama"},
                message.robots(), numbers, kMaxFrameBytes);
  }
  return description;
}

std::vector<Difference> differences(const Description& file, const Description& robot) {
  Comparison found;
  compare_sensations(file, robot, found);
  compare_commands(file, robot, found);
  found.number("", "tick_s", robot.tick_s, file.tick_s);
  const Body there = robot.body.value_or(Body{}), here = file.body.value_or(Body{});
  found.number("", "length_m", there.length_m, here.length_m);
  found.number("", "width_m", there.width_m, here.width_m);
  return found.take();
}

Sentence text_of(const Difference& difference) {
  if (difference.channel.empty()) return difference.text;
  return say({"{}: {}", "{}: {}"}, difference.channel, difference.text);
}

}  // namespace ganglion::link
