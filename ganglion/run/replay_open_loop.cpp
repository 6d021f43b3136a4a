#include "ganglion/run/replay_open_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ganglion/base/text.h"
#include "ganglion/graph/controller.h"
#include "ganglion/kinds/applications.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/record/csv.h"

namespace ganglion {
namespace {

/// Which CSV column feeds which value of a frame.
struct Feed {
  std::size_t column;
  std::size_t value;
  std::size_t channel;
};

std::vector<std::string> value_names(const ComponentModel& sensation, const SensationChannel& channel) {
  if (channel.elements.empty()) return {sensation.id};
  std::vector<std::string> names;
  for (const std::string& element : channel.elements) names.push_back(sensation.id + "." + element);
  return names;
}

std::vector<Feed> feeds_of(const ControllerModel& model, const Description& robot, const Csv& csv,
                           const std::string& file, Problems& problems) {
  std::vector<Feed> feeds;
  std::vector<std::string> known = {"time_s", "cost"};
  for (const ComponentModel& component : model.components) {
    if (component.component_class != ComponentClass::Sensation) continue;
    const auto channel = static_cast<std::size_t>(component.channel_index);
    const auto first = static_cast<std::size_t>(robot.sensation_offset(channel));
    const auto names = value_names(component, robot.sensations[channel]);
    for (std::size_t i = 0; i < names.size(); ++i) {
      known.push_back(names[i]);
      if (const auto column = csv.column(names[i])) feeds.push_back({*column, first + i, channel});
    }
  }
  for (std::size_t i = 0; i < csv.columns.size(); ++i) {
    const std::string& name = csv.columns[i];
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    problems.add(Error{ErrorCode::UnknownKey,
                       say({"column \"{}\" is no sensation of the controller{}",
                            "la columna \"{}\" no es una sensación del controlador{}"},
                           name, suggestion(name, known)),
                       {file, 1, 1},
                       {.found = name, .choices = known}});
  }
  if (!csv.column("time_s"))
    problems.add({file, 1, 1}, ErrorCode::MissingKey, {"the column time_s is missing", "falta la columna time_s"});
  return feeds;
}

std::string header_of(const ControllerModel& model, const Description& robot) {
  std::string line = "time_s";
  for (const CommandChannel& channel : robot.commands) {
    for (const CommandElement& element : channel.elements) line += "," + channel.name + "." + element.name;
  }
  for (const ComponentModel& component : model.components) {
    if (component.component_class == ComponentClass::Coordinator) line += "," + component.id + ".active";
  }
  return line + "\n";
}

/// The id of the candidate that a coordinator's `active` output names.
class Winner {
 public:
  Winner(const ComponentModel& coordinator, const Controller& controller) {
    const auto& signals = controller.signals();
    for (std::size_t i = 0; i < signals.size(); ++i) {
      if (signals[i].name == coordinator.id + ".active") signal_ = i;
    }
    for (const Wire& wire : coordinator.wires) {
      for (const Source& source : wire.sources) {
        if (source.kind == Source::Kind::ModuleCommand) candidates_.push_back(source.text);
      }
    }
  }
  std::string id(const Controller& controller) const {
    const double index = signal_ ? controller.values()[*signal_] : -1;
    return index >= 0 && index < static_cast<double>(candidates_.size()) ? candidates_[static_cast<std::size_t>(index)]
                                                                         : "";
  }

 private:
  std::optional<std::size_t> signal_;
  std::vector<std::string> candidates_;
};

/// Time until the next row; of the last row that of the one before, of a single row the controller's own.
double step_at(const Csv& csv, std::size_t time, std::size_t row, double preset_s) {
  const std::size_t from = row + 1 < csv.rows() ? row : row - std::min<std::size_t>(row, 1);
  return from + 1 < csv.rows() ? csv.at(from + 1, time) - csv.at(from, time) : preset_s;
}

double own_step_s(const ControllerModel& model, const Description& robot) noexcept {
  return model.tick_s > 0 ? model.tick_s : robot.tick_s;
}

constexpr double kFarFrom = 10;  // times as long or short as the controller's own

/// Times grow from row to row: of one that does not all that follows would be worth nothing.
void check_times(const Csv& csv, const std::string& file, double tick_s, Problems& problems) {
  const std::size_t time = *csv.column("time_s");
  std::vector<double> steps_s;
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const double now_s = csv.at(row, time),
                 before_s = row > 0 ? csv.at(row - 1, time) : -std::numeric_limits<double>::infinity();
    const Place place{file, static_cast<int>(row) + 2, 1};
    if (!std::isfinite(now_s)) {
      return problems.add(place, ErrorCode::BadParameter,
                          {"time_s is {}, must be a finite number", "time_s es {}, debe ser un número finito"},
                          shortest(now_s));
    }
    if (!(now_s > before_s)) {
      return problems.add(place, ErrorCode::BadParameter,
                          {"time_s is {}, must be after {} of the line before: times must grow",
                           "time_s es {}, debe ser posterior a {} de la línea anterior: los tiempos deben crecer"},
                          shortest(now_s), shortest(before_s));
    }
    if (row > 0) steps_s.push_back(now_s - before_s);
  }
  if (steps_s.empty()) return;
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  if (*middle<tick_s * kFarFrom&& * middle> tick_s / kFarFrom) return;
  const Text unit = *middle < 1e5 * tick_s   ? Text{"milliseconds", "milisegundos"}
                    : *middle < 1e8 * tick_s ? Text{"microseconds", "microsegundos"}
                                             : Text{"nanoseconds", "nanosegundos"};
  const Sentence far = say({"the steps of time_s are about {}, the controller's own is {}",
                            "los pasos de time_s son de unos {}, el del controlador es de {}"},
                           fmt::format("{:.3g} s", *middle), shortest(tick_s) + " s");
  const Sentence asked = *middle > tick_s ? say({"{}: are these {}?", "{}: ¿son {}?"}, far, unit) : far;
  problems.note({file, 2, 1}, asked);
}

std::string play(Controller& controller, const ControllerModel& model, const Description& robot, const Csv& csv,
                 const std::vector<Feed>& feeds) {
  SenseFrame sense = make_sense_frame(robot);
  ActFrame act = make_act_frame(robot);
  std::vector<Winner> winners;
  for (const ComponentModel& component : model.components) {
    if (component.component_class == ComponentClass::Coordinator) winners.emplace_back(component, controller);
  }
  const std::size_t time = *csv.column("time_s");
  const auto cost = csv.column("cost");
  const double preset_s = own_step_s(model, robot);
  std::string text = header_of(model, robot);
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    sense.tick = static_cast<std::uint32_t>(row);
    sense.time_s = csv.at(row, time);
    sense.cost = std::nullopt;
    if (cost && std::isfinite(csv.at(row, *cost))) sense.cost = csv.at(row, *cost);
    for (const Feed& feed : feeds) {
      sense.values[feed.value] = csv.at(row, feed.column);
      sense.ages_s[feed.channel] = 0;
    }
    controller.tick(sense, step_at(csv, time, row, preset_s), act);
    controller.grow();
    text += shortest(sense.time_s);
    for (const double value : act.values) text += "," + shortest(value);
    for (const Winner& winner : winners) text += "," + winner.id(controller);
    text += "\n";
  }
  return text;
}

}  // namespace

Result<std::string> replay_open_loop(const std::filesystem::path& path, const std::filesystem::path& inputs,
                                     Problems& problems) {
  const auto bad = [&]() { return tl::unexpected<Error>(problems.sorted().front()); };
  DiskFiles files;
  const auto file = files.open("controller", path.string(), -1, config::kMaxBytes);
  const auto root = file ? config::parse(files.at(*file)) : tl::unexpected<Error>(file.error());
  if (!root) {
    problems.add(root.error());
    return bad();
  }
  ControllerModel model = read_controller(*root, controller_kinds(), problems, &files);
  if (model.robot.empty())
    problems.add({path.string(), 1, 1}, ErrorCode::MissingKey, {"robot is missing", "falta robot"});
  if (!problems.empty()) return bad();
  const auto named = files.open("robot", model.robot.string(), -1, config::kMaxBytes);
  if (!named) problems.add(named.error());
  const auto robot = named ? read_description(files, *named, {}, problems) : std::nullopt;
  const auto csv = read_csv(inputs);
  if (!csv) problems.add(csv.error());
  if (!robot || !csv) return bad();
  resolve(model, *robot, problems);
  if (!problems.empty()) return bad();
  const auto feeds = feeds_of(model, *robot, *csv, inputs.string(), problems);
  if (!problems.empty()) return bad();
  check_times(*csv, inputs.string(), own_step_s(model, *robot), problems);
  if (!problems.empty()) return bad();
  auto controller = Controller::compile(model, *robot, controller_kinds(), {});
  if (!controller) {
    problems.add(controller.error());
    return bad();
  }
  return play(*controller, model, *robot, *csv, feeds);
}

}  // namespace ganglion
