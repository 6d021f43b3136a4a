#include "ganglion/run/experiment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/kinds/applications.h"
#include "ganglion/link/net/address.h"
#include "ganglion/run/near_file.h"

namespace ganglion {
namespace {

using config::Override;
using config::Table;

/// Keys that name a file; a longer --set path goes on inside it.
constexpr std::string_view kController = "controller", kRobot = "application.robot", kWorld = "application.world";

/// The part of an override's path behind a file's key, or nothing.
std::optional<std::string> behind(const Override& override, std::string_view key) {
  if (override.path.size() <= key.size() + 1 || !override.path.starts_with(key) || override.path[key.size()] != '.') {
    return std::nullopt;
  }
  return override.path.substr(key.size() + 1);
}

void sort_out(const std::vector<Override>& overrides, Experiment& experiment, std::vector<Override>& own) {
  for (const Override& override : overrides) {
    if (const auto inside = behind(override, kController)) {
      experiment.controller_overrides.push_back({*inside, override.value});
    } else if (const auto in_robot = behind(override, kRobot)) {
      experiment.robot_overrides.push_back({*in_robot, override.value});
    } else if (const auto in_world = behind(override, kWorld)) {
      experiment.world_overrides.push_back({*in_world, override.value});
    } else {
      own.push_back(override);
    }
  }
}

/// Keys of [application] that every application has.
constexpr std::array<std::string_view, 7> kEverywhere = {"robot",   "world", "robots",  "address",
                                                         "program", "pace",  "encoding"};

constexpr std::array<std::string_view, 2> kPaces = {"lock_step", "free_running"};
constexpr std::array<std::string_view, 2> kEncodings = {"binary", "json"};

LinkChoice read_link(Table& application) {
  LinkChoice link;
  link.address = application.text("address", "");
  link.program = application.texts("program");
  link.free_running = application.choice("pace", kPaces, 0) == 1;
  link.json = application.choice("encoding", kEncodings, 0) == 1;
  if (!link.address.empty()) {
    if (const auto address = link::parse_address(link.address); !address) {
      application.problem("address", address.error());
    }
    if (!link.program.empty()) {
      application.problem("program", ErrorCode::BadParameter,
                          {"give either an address, where a robot listens, or a program to start",
                           "dé una dirección, donde escucha un robot, o un programa que iniciar, no ambos"});
    }
  }
  return link;
}

std::vector<Criterion> read_criteria(Table& table, std::string_view key) {
  std::vector<Criterion> criteria;
  const std::vector<std::string> texts = table.texts(key);
  const config::Value* value = table.value(key);
  const config::Array* list = value != nullptr ? value->array() : nullptr;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (auto criterion = parse_criterion(texts[i])) {
      criterion->place = list != nullptr && i < list->size() ? (*list)[i].place() : table.place(key);
      criteria.push_back(std::move(*criterion));
    } else {
      table.problem(key, criterion.error());
    }
  }
  return criteria;
}

/// Opens the files that an experiment names, or those that take their place.
class NamedFiles {
 public:
  NamedFiles(FileReader* files, const ExperimentFiles& instead) : files_(files), instead_(instead) {}

  int open(Table& table, std::string_view key, std::filesystem::path ExperimentFiles::*which, Experiment& experiment) {
    const std::filesystem::path& other = instead_.*which;
    int index = -1;
    if (other.empty()) {
      index = table.open(key, key, config::kMaxBytes);
    } else {
      table.known(key);
      if (const auto opened = files_->open(key, other.string(), -1, config::kMaxBytes)) {
        index = *opened;
      } else {
        table.problems().add(opened.error());
      }
    }
    if (index >= 0) experiment.files.*which = files_->at(index).resolved;
    return index;
  }

 private:
  FileReader* files_;
  const ExperimentFiles& instead_;
};

void read_application(Table application, Experiment& experiment, NamedFiles& named, bool opens) {
  experiment.opened.robot = named.open(application, "robot", &ExperimentFiles::robot, experiment);
  experiment.opened.world = named.open(application, "world", &ExperimentFiles::world, experiment);
  experiment.robots = application.integer("robots", 1, config::Range{1, 10'000});
  experiment.places.robots = application.place("robots");
  experiment.link = read_link(application);
  if (!opens) return ask_application(application);  // nobody will read on
  for (const std::string& key : application.keys()) application.known(key);
}

void read_run(Table run, Experiment& experiment) {
  experiment.duration_s = run.number("duration_s", experiment.duration_s, config::Range{0, 1e6, true});
  experiment.seed = static_cast<std::uint64_t>(run.integer("seed", 1, config::kNotNegative));
  experiment.maps_every_s = run.number("maps_every_s", experiment.maps_every_s, config::kNotNegative);
  experiment.free_ground = run.boolean("free_ground", false);
  experiment.places.duration = run.place("duration_s");
  experiment.places.free_ground = run.place("free_ground");
  experiment.stop = read_criteria(run, "stop");
}

/// When it happens: `from_s` is a time, or [earliest, latest].
void read_window(Table& table, Fault& fault) {
  const config::Value* from = table.value("from_s");
  if (from != nullptr && from->array() != nullptr) {
    const std::vector<double> range = table.numbers("from_s", {}, 2, config::kNotNegative);
    if (range.size() == 2) std::tie(fault.from_s, fault.from_latest_s) = std::pair(range[0], range[1]);
    if (fault.from_latest_s < fault.from_s)
      table.problem("from_s", ErrorCode::BadParameter,
                    {"from_s = [earliest, latest] has its smaller number last",
                     "from_s = [primero, último] tiene el número menor al final"});
  } else {
    fault.from_s = table.number("from_s", 0, config::kNotNegative);
  }
  fault.to_s = table.number("to_s", fault.to_s, config::kPositive);
  if (fault.to_s <= fault.from_s)
    table.problem("to_s", ErrorCode::BadParameter, {"to_s is not after from_s", "to_s no viene después de from_s"});
  fault.chance = table.number("chance", 1, config::Range{0, 1});
}

FaultKind read_kind(Table& table) {
  const std::vector<std::string> names(kFaultNames.begin(), kFaultNames.end());
  table.asks("kind", {.form = config::Asked::Form::Choice, .required = true, .choices = names});
  if (!table.has("kind")) {
    table.problem("kind", ErrorCode::MissingKey, {"kind is missing: one of {}", "falta kind: uno de {}"}, join(names));
  }
  return static_cast<FaultKind>(table.choice("kind", kFaultNames, 0));
}

std::vector<Fault> read_faults(Table& root) {
  std::vector<Fault> faults;
  for (Table& table : root.tables("fault")) {
    Fault fault;
    fault.place = table.place("target");
    fault.target = table.text("target");
    table.set_context(fault.target);
    fault.kind = read_kind(table);
    fault.amount = table.number("amount", 0);
    fault.with = table.text("with", "");
    read_window(table, fault);
    faults.push_back(std::move(fault));
  }
  return faults;
}

/// The file itself; `table` is its root.
void read_table(Table table, Experiment& experiment, FileReader* files, const ExperimentFiles& instead) {
  table.opens_by(files);
  NamedFiles named(files, instead);
  config::check_format(table);
  experiment.name = table.text("name", experiment.files.experiment.parent_path().filename().string());
  experiment.opened.controller = named.open(table, "controller", &ExperimentFiles::controller, experiment);
  if (!table.has("controller") && instead.controller.empty()) table.text("controller");  // reports it missing
  experiment.success = read_criteria(table, "success");
  experiment.faults = read_faults(table);
  const config::Value* setting = table.value("application");
  experiment.setting =
      setting != nullptr && setting->table() != nullptr ? *setting : config::Value(config::Members(), table.place());
  read_application(table.table("application"), experiment, named, files != nullptr);
  read_run(table.table("run"), experiment);
}

}  // namespace

config::Table setting_of(const Experiment& experiment, Problems& problems) {
  Table setting(experiment.setting, "", problems);
  for (const std::string_view key : kEverywhere) setting.known(key);
  return setting;
}

Experiment parse_experiment(std::string_view text, const std::string& file_name, Problems& problems,
                            config::Outline* outline) {
  Experiment experiment;
  experiment.files.experiment = file_name;
  if (const auto root = config::parse(text, file_name)) {
    read_table(Table(*root, "", problems, outline), experiment, nullptr, {});
  } else {
    problems.add(root.error());
  }
  return experiment;
}

Experiment read_experiment(FileReader& files, const std::filesystem::path& given,
                           const std::vector<Override>& overrides, Problems& problems, const ExperimentFiles& instead) {
  Experiment experiment;
  experiment.overrides = overrides;
  std::error_code ignored;
  experiment.files.experiment = std::filesystem::is_directory(given, ignored) ? given / "experiment.toml" : given;
  const auto file = files.open("experiment", experiment.files.experiment.string(), -1, config::kMaxBytes);
  auto root = file ? config::parse(files.at(*file)) : tl::unexpected<Error>(file.error());
  if (!root) {
    problems.add(file ? root.error() : with_nearest(root.error(), given));
    return experiment;
  }
  experiment.opened.experiment = *file;
  std::vector<Override> own;
  sort_out(overrides, experiment, own);
  for (const Override& override : own) {
    if (auto applied = config::apply(*root, override); !applied) problems.add(applied.error());
  }
  read_table(Table(*root, "", problems), experiment, &files, instead);
  return experiment;
}

}  // namespace ganglion
