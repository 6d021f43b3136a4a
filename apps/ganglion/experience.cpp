#include <cstdio>
#include <ctime>

#include "commands.h"
#include "ganglion/experience/store.h"
#include "say.h"

namespace ganglion {
namespace {

std::string date_of(std::int64_t seconds) {
  const std::time_t time = seconds;
  std::tm parts{};
  ::gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

/// Opens one that is there.
Result<ExperienceStore> open(const std::string& file) {
  if (!std::filesystem::exists(file)) {
    return fail_at({file}, ErrorCode::NotFound, {"there is no such file", "no existe ese archivo"});
  }
  return ExperienceStore::open(file);
}

int show(const std::string& file) {
  const auto store = open(file);
  if (!store) return complain(store.error());
  const auto list = store->list();
  if (!list) return complain(list.error());
  tell({"{:<24}{:<24}{:>8}{:>12}  {}", "{:<24}{:<24}{:>8}{:>12}  {}"}, Text{"component", "componente"},
       Text{"kind", "tipo"}, Text{"parts", "partes"}, "bytes", Text{"saved", "guardado"});
  for (const StoredComponent& one : *list) {
    fmt::print("{:<24}{:<24}{:>8}{:>12}  {}\n", one.component, one.kind, one.parts, one.bytes, date_of(one.saved_s));
  }
  return kDone;
}

int forget(const std::string& file, const std::string& component) {
  auto store = open(file);
  if (!store) return complain(store.error());
  const auto dropped = store->forget(component);
  if (!dropped) return complain(dropped.error());
  tell({"{}: {} parts forgotten", "{}: {} partes olvidadas"}, component, *dropped);
  return kDone;
}

int rename(const std::string& file, const std::string& from, const std::string& to) {
  auto store = open(file);
  if (!store) return complain(store.error());
  const auto kept = store->rename(from, to);
  if (!kept) return complain(kept.error());
  tell({"{}: {} parts are those of {} now", "{}: {} partes son ahora de {}"}, from, *kept, to);
  return kDone;
}

}  // namespace

void add_experience(CLI::App& program, int& code) {
  struct ExperienceArguments {
    std::string file, component, to;
  };
  auto arguments = std::make_shared<ExperienceArguments>();
  CLI::App* command = program.add_subcommand("experience", "What controllers have learned and kept");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  ganglion run experiments/pathfinder --experience map.sqlite\n"
      "  ganglion experience show map.sqlite\n"
      "  ganglion experience rename map.sqlite router planner\n"
      "  ganglion experience forget map.sqlite router");
  CLI::App* shown = command->add_subcommand("show", "List what a file remembers");
  shown->add_option("file", arguments->file, "Experience file (.sqlite)")->required();
  shown->footer("Example:\n  ganglion experience show map.sqlite");
  shown->callback([arguments, &code] { code = show(arguments->file); });
  CLI::App* renamed = command->add_subcommand("rename", "Give what one component has learned to one of another name");
  renamed->add_option("file", arguments->file, "Experience file (.sqlite)")->required();
  renamed->add_option("old", arguments->component, "Its id so far")->required();
  renamed->add_option("new", arguments->to, "Its id in the controller now")->required();
  renamed->footer("Example:\n  ganglion experience rename map.sqlite router planner");
  renamed->callback([arguments, &code] { code = rename(arguments->file, arguments->component, arguments->to); });
  CLI::App* forgotten = command->add_subcommand("forget", "Drop what one component has learned");
  forgotten->add_option("file", arguments->file, "Experience file (.sqlite)")->required();
  forgotten->add_option("component", arguments->component, "Id in the controller")->required();
  forgotten->footer("Example:\n  ganglion experience forget map.sqlite router");
  forgotten->callback([arguments, &code] { code = forget(arguments->file, arguments->component); });
}

}  // namespace ganglion
