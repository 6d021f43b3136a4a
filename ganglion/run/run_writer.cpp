#include "ganglion/run/run_writer.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"
#include "ganglion/link/wire/words.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kInfo = 2, kWarning = 3;  // levels of foxglove.Log

/// What is recorded of a link; never part of a digest.
const std::array<SignalColumn, 6> kLinkColumns = {{{"link.round_trip_s", "s"},
                                                   {"link.clock_offset_s", "s"},
                                                   {"link.reconnections", ""},
                                                   {"link.repeated", ""},
                                                   {"link.lost", ""},
                                                   {"link.late", ""}}};

std::vector<SignalColumn> columns_of(const Controller& controller, std::span<const TruthChannel> truth) {
  std::vector<SignalColumn> columns;
  for (const TruthChannel& channel : truth) columns.push_back({"truth." + channel.name, channel.unit});
  for (const Signal& signal : controller.signals()) columns.push_back({signal.name, signal.unit});
  return columns;
}

/// A signal that shows a device's range: the sensation that is bound to it.
std::string signal_of(const std::string& device, const ControllerModel& model) {
  for (const ComponentModel& component : model.components) {
    const bool bound = component.channel == device + ".range" || component.channel == device;
    if (component.component_class == ComponentClass::Sensation && bound) return component.id;
  }
  return "";
}

Json mount_json(const Mount& mount, const ControllerModel& model) {
  return {{"id", mount.device},
          {"kind", mount.kind},
          {"x_m", mount.pose.position.x},
          {"y_m", mount.pose.position.y},
          {"yaw_rad", mount.pose.yaw.rad()},
          {"cone_rad", mount.cone_rad},
          {"max_range_m", mount.max_range_m},
          {"signal", signal_of(mount.device, model)}};
}

Json coordinators_json(const ControllerModel& model) {
  Json list = Json::array();
  for (const ComponentModel& component : model.components) {
    if (component.component_class != ComponentClass::Coordinator) continue;
    Json candidates = Json::array();
    for (const Wire& wire : component.wires) {
      for (const Source& source : wire.sources) {
        if (source.kind == Source::Kind::ModuleCommand) candidates.push_back(source.text);
      }
    }
    list.push_back({{"id", component.id}, {"candidates", candidates}});
  }
  return list;
}

/// The size of a map's cells, where a component keeps one.
double cell_of(const ControllerModel& model) {
  for (const ComponentModel& component : model.components) {
    if (component.descriptor != nullptr && component.component_class == ComponentClass::Acting &&
        component.descriptor->parameter("cell_m") != nullptr) {
      return component.parameters.real("cell_m");
    }
  }
  return 0;
}

/// As the log says it; English has its name_of().
Text words_of(ReasonCode code) noexcept {
  switch (code) {
    case ReasonCode::None:
      return {"none", "ninguna"};
    case ReasonCode::Unreachable:
      return {"unreachable", "inalcanzable"};
    case ReasonCode::Trapped:
      return {"trapped", "atrapado"};
    case ReasonCode::OutsideMap:
      return {"outside_map", "fuera del mapa"};
    case ReasonCode::BadRequest:
      return {"bad_request", "solicitud imposible"};
    case ReasonCode::NoReading:
      return {"no_reading", "sin lectura"};
    case ReasonCode::AttemptsExhausted:
      return {"attempts_exhausted", "intentos agotados"};
    case ReasonCode::Preempted:
      return {"preempted", "reemplazada"};
  }
  return Text::same(name_of(code));
}

/// The newest rows of a ledger that have a place, each with what became of it.
class RowsShown final : public Exhibitor {
 public:
  RowsShown(const LedgerForm& form, const Ledger& ledger) : form_(form), ledger_(ledger) {}

  void show(Exhibition& to) const override {
    constexpr std::size_t kNewest = 32;
    const std::size_t x = *form_.column("x_m"), y = *form_.column("y_m"), outcome = *form_.column("outcome");
    const std::size_t first = ledger_.rows() > kNewest ? ledger_.rows() - kNewest : 0;
    std::vector<Vector2> places;
    std::vector<std::string> ids;
    for (std::size_t row = first; row < ledger_.rows(); ++row) {
      places.push_back({ledger_.at(row, x), ledger_.at(row, y)});
      ids.push_back(fmt::format("goal {}", row + 1));
    }
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < places.size(); ++i) {
      shapes.push_back({.form = Form::Disc,
                        .role = role_of(form_.columns[outcome], ledger_.at(first + i, outcome)),
                        .id = ids[i],
                        .points = std::span(places).subspan(i, 1),
                        .label = Sentence::quoted(fmt::format("{}", first + i + 1))});
    }
    to.marks({.name = "goals", .title = form_.title, .shapes = shapes});
  }

 private:
  static Role role_of(const LedgerColumn& column, double value) noexcept {
    const auto known = static_cast<double>(column.roles.size());
    return value >= 0 && value < known ? column.roles[static_cast<std::size_t>(value)] : Role::Plain;
  }
  const LedgerForm& form_;
  const Ledger& ledger_;
};

bool has_places(const LedgerForm& form) {
  const auto outcome = form.column("outcome");
  return form.column("x_m") && form.column("y_m") && outcome && !form.columns[*outcome].roles.empty();
}

}  // namespace

RunWriter::RunWriter(RunSink& recorder, const Experiment& experiment, const ControllerModel& model,
                     const ApplicationModel& application, const RunRobots& robots,
                     const std::vector<std::unique_ptr<Controller>>& controllers)
    : recorder_(recorder),
      application_(robots.application()),
      witness_(robots.witness()),
      truth_(application.truth()),
      ledgers_(application.ledgers()),
      remote_(robots.remote()),
      controllers_(controllers),
      maps_every_s_(experiment.maps_every_s),
      cell_m_(cell_of(model)),
      exhibits_(recorder) {
  for (std::size_t i = 0; i < controllers.size(); ++i) {
    Robot one;
    const auto columns = columns_of(*controllers[i], truth_);
    one.table = recorder.add_table(fmt::format("/robot{}/signals", i), columns);
    one.row.resize(columns.size());
    one.ledgers.resize(ledgers_.size());
    one.statuses.assign(static_cast<std::size_t>(controllers[i]->components()), 0);
    robots_.push_back(std::move(one));
  }
  if (remote_ == nullptr) return;
  link_table_ = recorder.add_table("/link/signals", kLinkColumns);
  for (const link::Difference& one : remote_->differences()) {
    log(0, kWarning, "link", link::text_of(one));
  }
}

void RunWriter::write_scene(const std::string& scene, const Description& description, const ControllerModel& model) {
  if (!scene.empty()) recorder_.write_json("/scene", "ganglion.Scene", 0, scene);
  Json robot = {{"name", description.name}};
  if (description.body) {
    Json sensors = Json::array();
    for (const Mount& mount : description.body->mounts) sensors.push_back(mount_json(mount, model));
    robot.update({{"length_m", description.body->length_m},
                  {"width_m", description.body->width_m},
                  {"radius_m", description.body->radius_m},
                  {"sensors", sensors}});
  }
  for (const LedgerForm& form : ledgers_) {
    if (form.cell_m > 0) robot["goal_cell_m"] = form.cell_m;
  }
  const Json robots(controllers_.size(), robot);
  const Json run = {{"robots", robots}, {"coordinators", coordinators_json(model)}, {"cell_m", cell_m_}};
  recorder_.write_json("/run", "ganglion.Run", 0, run.dump());
}

void RunWriter::write(std::uint32_t tick, double time_s) {
  write_movers(time_s);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    write_truth(i);
    const auto values = controllers_[i]->values();
    std::copy(values.begin(), values.end(), robot.row.begin() + static_cast<std::ptrdiff_t>(truth_.size()));
    recorder_.write_row(robot.table, tick, time_s, robot.row);
    write_requests(static_cast<int>(i), time_s);
    write_ledgers(static_cast<int>(i), time_s);
  }
  if (remote_ != nullptr) write_link(tick, time_s);
  if (time_s + 1e-9 < next_maps_s_) return;
  next_maps_s_ = time_s + maps_every_s_;
  exhibits_.show(application_, {}, time_s);
  for (std::size_t i = 0; i < robots_.size(); ++i) write_exhibits(static_cast<int>(i), time_s);
}

void RunWriter::write_intervention(const InterventionDescriptor& descriptor, const TimedIntervention& one,
                                   double time_s) {
  recorder_.write_json(kInterventionTopic, kInterventionSchema, time_s, intervention_json(descriptor, one));
  log(time_s, kInfo, "intervention", text_of(descriptor, one.what));
  write_movers(time_s);
  for (std::size_t i = 0; i < robots_.size(); ++i) write_ledgers(static_cast<int>(i), time_s);
}

void RunWriter::write_truth(std::size_t robot) {
  std::vector<double>& row = robots_[robot].row;
  if (witness_ == nullptr) {
    std::fill_n(row.begin(), truth_.size(), std::numeric_limits<double>::quiet_NaN());
    return;
  }
  std::ranges::copy(witness_->truth_of(static_cast<int>(robot)), row.begin());
}

void RunWriter::write_link(std::uint32_t tick, double time_s) {
  const link::LinkStatistics& now = remote_->statistics();
  const std::array<double, kLinkColumns.size()> row = {now.round_trip_s,
                                                       now.clock_offset_s,
                                                       static_cast<double>(now.reconnections),
                                                       static_cast<double>(now.repeated),
                                                       static_cast<double>(now.lost),
                                                       static_cast<double>(now.late)};
  recorder_.write_row(link_table_, tick, time_s, row);
  for (const link::wire::Event& event : remote_->take_events()) {
    const int level = kInfo + std::clamp(static_cast<int>(event.level()), 0, 2);
    log(time_s, level, "robot", link::read_words(event));
  }
}

void RunWriter::write_movers(double time_s) {
  const auto now = witness_ != nullptr ? witness_->movers() : std::span<const PlacedMover>{};
  std::uint64_t hash = 1;
  for (const PlacedMover& mover : now) {
    hash = combine(hash, canonical_bits(mover.pose.position.x));
    hash = combine(hash, canonical_bits(mover.pose.position.y) ^ canonical_bits(mover.pose.yaw.rad()));
  }
  if (hash == movers_shown_ || now.empty()) return;
  movers_shown_ = hash;
  Json movers = Json::array();
  for (const PlacedMover& mover : now) {
    movers.push_back({{"id", mover.id},
                      {"x_m", mover.pose.position.x},
                      {"y_m", mover.pose.position.y},
                      {"yaw_rad", mover.pose.yaw.rad()}});
  }
  recorder_.write_json("/movers", "ganglion.Movers", time_s, Json{{"movers", movers}}.dump());
}

void RunWriter::log(double time_s, int level, const std::string& name, const Sentence& message) {
  const auto seconds = static_cast<long>(time_s);
  const Json json = {
      {"timestamp", {{"sec", seconds}, {"nsec", static_cast<long>((time_s - static_cast<double>(seconds)) * 1e9)}}},
      {"level", level},
      {"message", message.en},
      {"message_es", message.es},
      {"name", name}};
  recorder_.write_json("/log", "foxglove.Log", time_s, json.dump());
}

void RunWriter::write_requests(int robot, double time_s) {
  const Controller& controller = *controllers_[static_cast<std::size_t>(robot)];
  for (int i = 0; i < controller.components(); ++i) {
    const RequestSlot* request = controller.request(i);
    if (request == nullptr) continue;
    std::uint8_t& before = robots_[static_cast<std::size_t>(robot)].statuses[static_cast<std::size_t>(i)];
    const auto now = static_cast<std::uint8_t>(request->status);
    if (now != before && request->status == RequestStatus::Withdrawn) {
      log(time_s, kWarning, controller.id(i),
          say({"withdrawn: {} ({:g}, {:g})", "retirada: {} ({:g}, {:g})"}, words_of(request->reason.code),
              request->reason.first, request->reason.second));
    }
    before = now;
  }
}

void RunWriter::write_ledgers(int robot, double time_s) {
  for (std::size_t n = 0; n < ledgers_.size() && witness_ != nullptr; ++n) {
    const LedgerForm& form = ledgers_[n];
    const Ledger* ledger = witness_->ledger(robot, form.task);
    LedgerWritten& written = robots_[static_cast<std::size_t>(robot)].ledgers[n];
    if (ledger == nullptr || ledger->changes() == written.changes) continue;
    written.changes = ledger->changes();
    const auto outcome = form.column("outcome");
    for (std::size_t row = written.outcomes.empty() ? 0 : written.outcomes.size() - 1; row < ledger->rows(); ++row) {
      const double now = outcome ? ledger->at(row, *outcome) : 0;
      if (row < written.outcomes.size() && written.outcomes[row] == now) continue;
      written.outcomes.resize(std::max(written.outcomes.size(), row + 1));
      written.outcomes[row] = now;
      write_row(robot, form, *ledger, row, time_s);
    }
    if (has_places(form)) exhibits_.show(RowsShown(form, *ledger), {robot, form.task}, time_s);
  }
}

void RunWriter::write_row(int robot, const LedgerForm& form, const Ledger& ledger, std::size_t row, double time_s) {
  std::vector<double> values;
  for (std::size_t n = 0; n < form.columns.size(); ++n) values.push_back(ledger.at(row, n));
  if (!form.line.empty()) log(time_s, kInfo, form.task, row_text(form, row, values));
  const auto x = form.column("x_m"), y = form.column("y_m"), outcome = form.column("outcome"),
             reason = form.column("reason");
  if (!x || !y || !outcome) return;  // it has no place
  const auto& words = form.columns[*outcome].words;
  const auto state = static_cast<std::size_t>(std::clamp(values[*outcome], 0.0, 255.0));
  const auto why = static_cast<ReasonCode>(reason ? std::clamp(values[*reason], 0.0, 65535.0) : 0);
  const Json json = {{"index", row},
                     {"x_m", values[*x]},
                     {"y_m", values[*y]},
                     {"state", state < words.size() ? words[state].en : std::to_string(state)},
                     {"reason", name_of(why)}};
  recorder_.write_json(fmt::format("/robot{}/goals", robot), "ganglion.Goal", time_s, json.dump());
}

void RunWriter::write_exhibits(int robot, double time_s) {
  const Controller& controller = *controllers_[static_cast<std::size_t>(robot)];
  for (int i = 0; i < controller.components(); ++i) {
    const Component* component = controller.component(i);
    if (component == nullptr) continue;
    exhibits_.show(*component, {robot, controller.id(i)}, time_s);
  }
}

}  // namespace ganglion
