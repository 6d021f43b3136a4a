#include "ganglion/studio/api/wanted.h"

#include <algorithm>
#include <array>

#include "ganglion/base/text.h"
#include "ganglion/config/source/source_map.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

/// Keys by which --set could name files or programs: these have fields of their own, which are checked.
constexpr std::array<std::string_view, 6> kNotSet = {"controller",        "application",         "application.robot",
                                                     "application.world", "application.program", "application.address"};

Reply not_listed(const Ask& ask, const std::string& program) {
  const Sentence what = say({"the studio starts only programs that are listed in your own studio.toml",
                             "el estudio solo inicia programas que figuran en su propio studio.toml"});
  return ask.refuse("ProgramNotListed", what, 403, {{"program", program}});
}

Json problems_json(const Problems& problems, Language language) {
  Json list = Json::array();
  for (const Error& error : problems.sorted()) {
    list.push_back({{"code", name_of(error.code)},
                    {"message", error.what.in(language)},
                    {"file", fs::path(error.place.file).filename().string()},
                    {"line", error.place.line},
                    {"column", error.place.column}});
  }
  return list;
}

Reply problems_reply(const Problems& problems, Language language) {
  const auto sorted = problems.sorted();
  return failure("BadParameter", sorted.empty() ? Sentence{} : sorted.front().what, language, 400,
                 {{"problems", problems_json(problems, language)}});
}

}  // namespace

Result<link::Address> allowed_address(const std::string& text) {
  constexpr std::string_view kSerial = "/dev/tty";
  auto address = link::parse_address(text);
  if (!address || address->kind != link::Address::Kind::Serial) return address;
  const bool terminal =
      address->device.starts_with(kSerial) && address->device.find('/', kSerial.size()) == std::string::npos;
  if (!terminal)
    return fail(ErrorCode::BadParameter,
                {"a serial address must lead to /dev/tty...", "una dirección serie debe llevar a /dev/tty..."});
  return address;
}

Result<void> WantedReader::read_files(const Ask& ask, Wanted& wanted) const {
  const auto experiment = folder_.resolve(ask.text("experiment"));
  if (!experiment) return tl::unexpected<Error>(experiment.error());
  wanted.experiment = *experiment;
  for (const auto& [key, file] : {std::pair{"world", &wanted.instead.world}, {"robot", &wanted.instead.robot}}) {
    if (!ask.has(key)) continue;
    const auto path = folder_.resolve(ask.text(key));
    if (!path) return tl::unexpected<Error>(path.error());
    *file = *path;
  }
  if (!ask.has("controller")) return {};
  const Json& controller = ask.body["controller"];
  const auto path = folder_.resolve(controller.is_object() ? controller.value("path", "") : "");
  if (!path) return tl::unexpected<Error>(path.error());
  wanted.instead.controller = *path;
  if (controller.contains("text") && controller["text"].is_string())
    wanted.drawn = controller["text"].get<std::string>();
  return {};
}

std::optional<Reply> WantedReader::read_sets(const Ask& ask, Wanted& wanted) const {
  for (const Json& one : ask.body.value("set", Json::array())) {
    const auto set = config::parse_override(one.is_string() ? one.get<std::string>() : std::string());
    if (!set) return failure(set.error(), ask.language);
    if (std::find(kNotSet.begin(), kNotSet.end(), set->path) != kNotSet.end()) {
      return ask.refuse("Forbidden", say({"{} cannot be set so", "{} no se puede fijar así"}, set->path), 403);
    }
    wanted.overrides.push_back(*set);
  }
  if (ask.has("duration_s")) wanted.overrides.push_back({"run.duration_s", shortest(ask.number("duration_s", 60))});
  return std::nullopt;
}

/// Where the robot is: an address, "" for the simulation, or a listed program. One of them takes the others' place.
std::optional<Reply> WantedReader::read_application(const Ask& ask, Wanted& wanted) const {
  if (!ask.has("address") && !ask.has("program")) return std::nullopt;
  if (ask.has("address") && ask.has("program")) {
    return ask.refuse("BadParameter",
                      say({"give either an address or a program", "dé una dirección o un programa, no ambos"}), 400);
  }
  std::string address, command;
  if (ask.has("address") && !ask.text("address").empty()) {
    const auto allowed = allowed_address(ask.text("address"));
    if (!allowed) return ask.refuse("Forbidden", allowed.error().what, 403);
    address = wanted.link.address = allowed->text;
  }
  if (ask.has("program")) {
    const auto program = std::find_if(programs_.begin(), programs_.end(),
                                      [&](const AllowedProgram& one) { return one.name == ask.text("program"); });
    if (program == programs_.end()) {
      return not_listed(ask, ask.text("program"));
    }
    wanted.link.program = program->command;
    for (const std::string& word : program->command) command += (command.empty() ? "" : ", ") + config::toml_text(word);
  }
  wanted.overrides.push_back({"application.address", config::toml_text(address)});
  wanted.overrides.push_back({"application.program", "[" + command + "]"});
  return std::nullopt;
}

std::optional<Reply> WantedReader::read_wanted(const Ask& ask, Wanted& wanted) const {
  if (const auto read = read_files(ask, wanted); !read) return failure(read.error(), ask.language);
  if (auto refused = read_sets(ask, wanted)) return refused;
  return read_application(ask, wanted);
}

/// Nothing is read outside of the folder, and no program started but those the user lists.
std::optional<Reply> WantedReader::refuse_experiment(const Experiment& experiment, const FolderFiles& files,
                                                     const Ask& ask) const {
  const LinkChoice& link = experiment.link;
  const bool listed = link.program.empty() || std::any_of(programs_.begin(), programs_.end(),
                                                          [&](const auto& one) { return one.command == link.program; });
  if (!listed) return not_listed(ask, link.program.front());
  if (!link.address.empty()) {
    if (const auto allowed = allowed_address(link.address); !allowed) {
      return ask.refuse("Forbidden", allowed.error().what, 403);
    }
  }
  if (files.outside().empty()) return std::nullopt;
  return ask.refuse("Outside",
                    say({"the experiment names a file outside of the studio's folder",
                         "el experimento nombra un archivo fuera de la carpeta del estudio"}),
                    403, {{"file", files.outside().filename().string()}});
}

std::optional<Reply> WantedReader::read_through(FolderFiles& files, const Wanted& wanted, const Ask& ask,
                                                Experiment& experiment) const {
  Problems problems;
  if (wanted.drawn) files.hold("controller", wanted.instead.controller, *wanted.drawn);
  experiment = read_experiment(files, wanted.experiment, wanted.overrides, problems, wanted.instead);
  return refuse_experiment(experiment, files, ask);
}

std::optional<Reply> WantedReader::read_experiment_of(const Wanted& wanted, const Ask& ask,
                                                      Experiment& experiment) const {
  FolderFiles files(folder_);
  return read_through(files, wanted, ask, experiment);
}

std::optional<Reply> WantedReader::prepare_wanted(const Wanted& wanted, const Ask& ask,
                                                  std::optional<Prepared>& prepared) const {
  FolderFiles files(folder_);
  Experiment named;
  if (auto refused = read_through(files, wanted, ask, named)) return refused;
  Problems problems;
  prepared = prepare(files, wanted.experiment, wanted.overrides, problems, wanted.instead);
  if (auto refused = refuse_experiment(named, files, ask)) return refused;
  if (!prepared) return problems_reply(problems, ask.language);
  return std::nullopt;
}

}  // namespace ganglion::studio
