#include <algorithm>
#include <cstdio>

#include "commands.h"
#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/record/catalogue.h"
#include "ganglion/record/compare_components.h"
#include "ganglion/record/csv.h"
#include "ganglion/record/recover.h"
#include "ganglion/record/run_file.h"
#include "ganglion/run/inputs.h"
#include "language.h"
#include "results_reader.h"
#include "say.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

struct RunsArguments {
  std::string folder = "runs";
  std::string file, out, sort = "recorded", name;
  std::vector<std::string> files;
};

/// The runs of a folder, read anew from the files: the catalogue is only an index.
Result<std::vector<RunSummary>> runs_of(const RunsArguments& arguments) {
  if (!fs::is_directory(arguments.folder)) {
    return fail_at({arguments.folder}, ErrorCode::NotFound,
                   {"there is no such folder; runs are written by ganglion run",
                    "no existe esa carpeta; las ejecuciones las escribe ganglion run"});
  }
  auto catalogue = RunCatalogue::open(arguments.folder);
  if (!catalogue) return tl::unexpected<Error>(catalogue.error());
  const auto rebuilt = catalogue->rebuild();
  if (!rebuilt) return tl::unexpected<Error>(rebuilt.error());
  for (const Error& problem : rebuilt->problems) {
    note(say({"left out: {}", "omitido: {}"}, problem.text(language())));
  }
  RunFilter filter;
  filter.sort_by = arguments.sort;
  filter.descending = arguments.sort == "recorded";
  filter.limit = 100'000;
  if (!arguments.name.empty()) filter.name = arguments.name;
  return catalogue->list(filter);
}

constexpr Text outcome_of(Verdict verdict) noexcept {
  if (verdict == Verdict::NotJudged) return {"not judged", "sin juzgar"};
  return verdict == Verdict::Succeeded ? Text{"success", "éxito"} : Text{"failed", "fallida"};
}

int list(const RunsArguments& arguments) {
  const auto runs = runs_of(arguments);
  if (!runs) return complain(runs.error());
  const auto row = [](const auto&... cells) {
    tell({"{:<36}{:<26}{:>6}  {:<12}{:<18}{}", "{:<36}{:<26}{:>7}  {:<12}{:<18}{}"}, cells...);
  };
  row(Text{"file", "archivo"}, Text{"experiment", "experimento"}, Text{"seed", "semilla"}, Text{"outcome", "resultado"},
      Text{"digest", "huella"}, Text{"reason", "motivo"});
  for (const RunSummary& run : *runs) {
    row(run.file, run.name, run.seed, run.finished ? outcome_of(run.verdict) : Text{"cut", "cortada"}, run.digest,
        recorded(run.reason));
  }
  return kDone;
}

int csv(const RunsArguments& arguments) {
  const auto runs = runs_of(arguments);
  if (!runs) return complain(runs.error());
  const std::string text = to_csv(*runs);
  if (arguments.out.empty())
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? kDone : kOutputFailed;
  if (const auto written = write_file(arguments.out, text); !written) {
    complain(written.error());
    return kOutputFailed;
  }
  return kDone;
}

int show(const RunsArguments& arguments) {
  const auto run = RunFile::read(arguments.file, Recover::Yes);
  if (!run) return complain(run.error());
  tell({"{}, seed {}, tick {} s", "{}, semilla {}, ciclo de {} s"}, run->info.name, run->info.seed,
       shortest(run->info.tick_s));
  for (const Sentence& damage : run->damages) tell({"damaged: {}", "dañado: {}"}, damage);
  if (run->outcome) {
    tell({"{}: {}\ndigest {}", "{}: {}\nhuella {}"}, outcome_of(run->outcome->verdict), recorded(run->outcome->reason),
         run->outcome->digest);
    for (const auto& [name, value] : run->outcome->measures) fmt::print("  {:<26}{}\n", name, shortest(value));
  } else {
    tell({"cut: the run has no outcome", "cortada: la ejecución no tiene resultado"});
  }
  for (const SignalTable& table : run->tables) {
    tell({"{}: {} ticks of {} signals", "{}: {} ciclos de {} señales"}, table.topic, table.rows(),
         table.columns.size());
  }
  for (const auto& [topic, messages] : run->json) {
    tell({"{}: {} messages", "{}: {} mensajes"}, topic, messages.messages.size());
  }
  for (const auto& attachment : run->attachments) {
    tell({"holds {} ({} bytes)", "contiene {} ({} bytes)"}, attachment.name, attachment.bytes.size());
  }
  return kDone;
}

int signals(const RunsArguments& arguments) {
  const auto run = RunFile::read(arguments.file, Recover::Yes);
  if (!run) return complain(run.error());
  for (const SignalTable& table : run->tables) {
    std::string name = table.topic.substr(table.topic.starts_with('/') ? 1 : 0);
    std::replace(name.begin(), name.end(), '/', '_');
    const fs::path file = fs::path(arguments.out) / (name + ".csv");
    if (const auto written = write_csv(table, file); !written) return complain(written.error());
    tell({"wrote {}", "escrito {}"}, file.string());
  }
  return kDone;
}

/// A file of another program, as far as it can be checked without knowing what it holds.
int verify_foreign(const std::string& file) {
  const auto content = read_mcap(file, Recover::No, [](const mcap::Channel&, const mcap::Message&) {});
  if (!content) return complain(content.error());
  tell({"{}: whole, of another program ({}): no run, {} messages in {} channels",
        "{}: entero, de otro programa ({}): ninguna ejecución, {} mensajes en {} canales"},
       file, content->library.empty() ? "?" : printable(content->library, 80), content->messages,
       content->channels.size());
  return kDone;
}

int verify(const RunsArguments& arguments) {
  int worst = kDone;
  for (const std::string& file : arguments.files) {
    const auto run = RunFile::read(file);  // every checksum
    if (!run) {
      const bool foreign = run.error().code == ErrorCode::Unsupported;  // holds no run
      worst = std::max(worst, foreign ? verify_foreign(file) : complain(run.error()));
      continue;
    }
    if (run->outcome) {
      tell({"{}: whole, digest {}", "{}: entero, huella {}"}, file, run->outcome->digest);
    } else {
      tell({"{}: whole, cut before its outcome", "{}: entero, cortado antes de su resultado"}, file);
    }
  }
  return worst;
}

/// A file that was cut while its inputs were written holds not all of them.
void tell_lost_inputs(const std::string& file) {
  const auto run = RunFile::read_summary(file);
  if (!run) return;
  const auto inputs = AttachedFiles::of(*run);
  const auto lost = inputs ? (*inputs)->missing() : std::vector<std::string>{"inputs.json"};
  if (lost.empty()) return;
  note(say({"{}: lost are {}: it cannot be replayed", "{}: se perdieron {}: no se puede repetir"}, file,
           join(lost, ", ")));
}

int recover(const RunsArguments& arguments) {
  const auto saved = recover_run(arguments.file, arguments.out);
  if (!saved) return complain(saved.error());
  for (const Sentence& damage : saved->damages) tell({"damaged: {}", "dañado: {}"}, damage);
  const Text outcome = saved->finished ? Text{", its outcome", ", su resultado"}
                                       : Text{"; its outcome is lost", "; su resultado se perdió"};
  tell({"saved {} chunks, {} messages, {:.1f} s of the run{}\nwrote {}",
        "se salvaron {} bloques, {} mensajes, {:.1f} s de la ejecución{}\nescrito {}"},
       saved->chunks, saved->messages, saved->until_s, outcome, arguments.out);
  tell_lost_inputs(arguments.out);
  return kDone;
}

/// Whether what two runs have in common went the same way in both.
int digests(const RunsArguments& arguments) {
  std::vector<RunOutcome> outcomes;
  for (const std::string& file : arguments.files) {
    auto run = RunFile::read_summary(file);
    if (!run) return complain(run.error());
    if (!run->outcome) {
      return complain(
          Error{ErrorCode::Corrupt, say({"was cut before its outcome", "se cortó antes de su resultado"}), {file}});
    }
    outcomes.push_back(std::move(*run->outcome));
  }
  const DigestComparison found = compare_components(outcomes[0], outcomes[1]);
  const auto list_all = [](Text what, const std::vector<std::string>& names) {
    for (const std::string& name : names) tell({"{} {}", "{} {}"}, what, name);
  };
  list_all({"same     ", "igual    "}, found.same);
  list_all({"differs  ", "difiere  "}, found.different);
  list_all({"only in 1", "solo en 1"}, found.only_first);
  list_all({"only in 2", "solo en 2"}, found.only_second);
  tell({"{} the same, {} different, {} in one run only", "{} iguales, {} diferentes, {} solo en una ejecución"},
       found.same.size(), found.different.size(), found.only_first.size() + found.only_second.size());
  return found.different.empty() ? kDone : kRobotFailed;
}

/// The page, and what it says first: how many of each batch's judged runs succeeded.
int compare(const RunsArguments& arguments) {
  Problems problems;
  std::vector<report::NamedBatch> batches;
  for (const std::string& file : arguments.files) {
    if (auto batch = read_batch(file)) {
      batches.push_back(std::move(*batch));
    } else {
      problems.add(batch.error());
    }
  }
  if (!problems.empty()) return complain(problems);
  tell({"{:<26}{:>8}{:>11}  {}", "{:<26}{:>12}{:>11}  {}"}, Text{"batch", "serie"}, Text{"runs", "ejecuciones"},
       Text{"succeeded", "con éxito"}, Text{"95 % interval of the share", "intervalo del 95 % de la proporción"});
  for (const report::NamedBatch& batch : batches) {
    const auto [judged, won] = report::successes_of(batch);
    const report::Interval interval = report::wilson(won, judged);
    tell({"{:<26}{:>8}{:>11}  {}", "{:<26}{:>12}{:>11}  {}"}, batch.name, batch.runs.size(),
         judged > 0 ? std::to_string(won) : "-",
         judged > 0 ? fmt::format("{:.3f} .. {:.3f}", interval.lower, interval.upper) : "-");
  }
  if (const auto written = report::write_comparison(batches, arguments.out, language()); !written) {
    complain(written.error());
    return kOutputFailed;
  }
  tell({"wrote {}", "escrito {}"}, arguments.out);
  return kDone;
}

void add_compare(CLI::App& command, const std::shared_ptr<RunsArguments>& arguments, int& code) {
  CLI::App* compared = command.add_subcommand("compare", "Set batches of runs side by side on one page");
  compared->add_option("batches", arguments->files, "[NAME=]RESULTS.json of run --json, or [NAME=]FOLDER of run files")
      ->required();
  compared->add_option("--out", arguments->out, "Page to write (.html)")->required();
  compared->footer(
      "Example:\n"
      "  ganglion run experiments/nimrod --seeds 1..100 --json > recommended.json\n"
      "  ganglion run experiments/nimrod --set controller=experiments/nimrod/controller.listing.toml \\\n"
      "    --seeds 1..100 --json > listing.json\n"
      "  ganglion runs compare recommended.json listing.json --out presets.html");
  compared->callback([arguments, &code] { code = compare(*arguments); });
}

}  // namespace

void add_runs(CLI::App& program, int& code) {
  auto arguments = std::make_shared<RunsArguments>();
  CLI::App* command = program.add_subcommand("runs", "Recorded runs: list, show, export, verify, recover, compare");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  ganglion runs list\n"
      "  ganglion runs csv runs/nimrod --out runs.csv\n"
      "  ganglion runs show runs/nimrod/seed_0001.mcap\n"
      "Exit codes: 0 done, 1 digests: a component differs, 2 bad input or a wrong checksum, 4 a file cannot be "
      "written.");
  CLI::App* listed = command->add_subcommand("list", "List the runs below a folder");
  CLI::App* exported = command->add_subcommand("csv", "The same as a table, every measure a column");
  for (CLI::App* one : {listed, exported}) {
    one->add_option("folder", arguments->folder, "Default: runs");
    one->add_option("--sort", arguments->sort, "recorded, file, name, seed, success, digest, or a measure");
    one->add_option("--name", arguments->name, "Only runs of this experiment");
  }
  listed->footer("Example:\n  ganglion runs list runs --sort travelled_m");
  exported->footer("Example:\n  ganglion runs csv runs --out runs.csv");
  listed->callback([arguments, &code] { code = list(*arguments); });
  exported->add_option("--out", arguments->out, "File to write; default: standard output");
  exported->callback([arguments, &code] { code = csv(*arguments); });
  CLI::App* shown = command->add_subcommand("show", "What one run file holds");
  shown->add_option("file", arguments->file, "Run file (.mcap)")->required();
  shown->footer("Example:\n  ganglion runs show runs/nimrod/seed_0001.mcap");
  shown->callback([arguments, &code] { code = show(*arguments); });
  CLI::App* signal = command->add_subcommand("signals", "Every robot's signals as CSV");
  signal->add_option("file", arguments->file, "Run file (.mcap)")->required();
  signal->add_option("--out", arguments->out, "Folder to write to")->required();
  signal->footer("Example:\n  ganglion runs signals runs/nimrod/seed_0001.mcap --out tables");
  signal->callback([arguments, &code] { code = signals(*arguments); });
  CLI::App* recovered = command->add_subcommand("recover", "Make a whole run file of what is left of a cut one");
  recovered->add_option("file", arguments->file, "Run file (.mcap), which is only read")->required();
  recovered->add_option("--out", arguments->out, "File to write")->required();
  recovered->footer(
      "Example:\n"
      "  ganglion runs recover cut.mcap --out whole.mcap\n"
      "Exit codes: 0 saved, 2 nothing of a run is left, 4 the new file cannot be written.");
  recovered->callback([arguments, &code] { code = recover(*arguments); });
  CLI::App* digested =
      command->add_subcommand("digests", "Which components of two runs had the same signals, to the bit");
  digested->add_option("files", arguments->files, "Two run files (.mcap)")->required()->expected(2);
  digested->footer(
      "Example:\n"
      "  ganglion runs digests before/seed_0001.mcap after/seed_0001.mcap\n"
      "Exit codes: 0 what both have is the same, 1 it differs, 2 bad input.");
  digested->callback([arguments, &code] { code = digests(*arguments); });
  CLI::App* verified = command->add_subcommand("verify", "Check every checksum of run files");
  verified->add_option("files", arguments->files, "Run files (.mcap)")->required();
  verified->footer(
      "Example:\n"
      "  ganglion runs verify runs/nimrod/*.mcap\n"
      "Exit codes: 0 whole, 2 a checksum is wrong.");
  verified->callback([arguments, &code] { code = verify(*arguments); });
  add_compare(*command, arguments, code);
}

}  // namespace ganglion
