#include <cstdio>

#include "commands.h"
#include "ganglion/base/text.h"
#include "ganglion/lab/batch.h"
#include "ganglion/lab/fault_matrix.h"
#include "ganglion/lab/kept_experience.h"
#include "interrupt.h"
#include "language.h"
#include "overrides.h"
#include "results_json.h"
#include "say.h"
#include "watched_run.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string experiment;
  std::vector<std::string> set;
  std::uint64_t seed = 0;
  bool has_seed = false;
  std::string seeds;
  std::string faults;
  std::string robot;
  std::string pace = "max";
  std::string out;
  std::string experience;
  int threads = 0;
  bool json = false;
  bool no_record = false;
  bool no_report = false;
  bool studio = false;
};

/// --robot is an application.address.
std::vector<config::Override> overrides_of(const RunArguments& arguments, Problems& problems) {
  auto overrides = overrides_of(arguments.set, problems);
  if (!arguments.robot.empty()) {
    overrides.push_back({"application.program", "[]"});
    overrides.push_back({"application.address", arguments.robot});
  }
  return overrides;
}

Result<double> pace_of(const std::string& text) {
  if (text == "max") return 0.0;
  std::string_view number = text;
  if (number.ends_with('x')) number.remove_suffix(1);
  const auto factor = parse_number(number);
  if (factor && *factor > 0 && std::isfinite(*factor)) return *factor;
  return fail(ErrorCode::BadParameter,
              {"--pace {}: write max, or a multiple of real time such as 1x or 0.5x",
               "--pace {}: escriba max, o un múltiplo del tiempo real como 1x o 0.5x"},
              text);
}

constexpr std::uint64_t kFaultSeeds = 20;  // of --faults without --seeds

struct SeedRange {
  std::uint64_t first, last;
};

Result<SeedRange> seeds_of(const std::string& text) {
  const auto dots = text.find("..");
  const auto first = parse_number(text.substr(0, dots));
  const auto last = dots != std::string::npos ? parse_number(text.substr(dots + 2)) : first;
  const bool whole = first && last && *first == std::floor(*first) && *last == std::floor(*last);
  if (!whole || *first < 0 || *last < *first || *last - *first >= 1e6 || *last > 9e15) {
    return fail(ErrorCode::BadParameter,
                {"--seeds {}: write two whole numbers, as in 1..100 (at most a million)",
                 "--seeds {}: escriba dos números enteros, como 1..100 (un millón como máximo)"},
                text);
  }
  return SeedRange{static_cast<std::uint64_t>(*first), static_cast<std::uint64_t>(*last)};
}

/// "runs/nimrod": the folder's name, or the file's where that says more.
fs::path output_folder(const RunArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  fs::path named = fs::path(arguments.experiment).lexically_normal();
  if (!named.has_filename()) named = named.parent_path();
  return fs::path("runs") /
         (named.stem() == "experiment" ? fs::absolute(named).parent_path().filename() : named.stem());
}

fs::path run_file(const fs::path& folder, std::uint64_t seed) { return folder / fmt::format("seed_{:04}.mcap", seed); }

lab::Job job_of(const Prepared& prepared, const RunArguments& arguments, std::uint64_t seed) {
  return {.experiment = arguments.experiment, .overrides = prepared.experiment.overrides, .seed = seed, .faults = {}};
}

lab::Keep keep_of(const RunArguments& arguments, std::uint64_t seed) {
  return {.run_file = arguments.no_record ? fs::path() : run_file(output_folder(arguments), seed),
          .report = !arguments.no_report,
          .catalogue = true,
          .experience = arguments.experience,
          .language = language()};
}

int print(const RunArguments& arguments, const std::vector<lab::Outcome>& outcomes) {
  const std::string text = arguments.json ? results_json(outcomes) : results_table(outcomes, language());
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  return written ? kDone : kOutputFailed;
}

/// Says what could not be kept. Returns an exit code: a catalogue that cannot be written is no loss.
int complain_of(const lab::Outcome& outcome) {
  int code = kDone;
  for (const lab::Trouble& trouble : outcome.troubles) {
    if (trouble.of == lab::Trouble::Of::Link) continue;  // that is said last
    complain(trouble.error);
    if (trouble.of == lab::Trouble::Of::Files) code = kOutputFailed;
  }
  return code;
}

/// Says where runs have other names than they were to have, since their own were taken by different ones.
void tell_names(const RunArguments& arguments, const std::vector<lab::Outcome>& outcomes) {
  const auto renamed = [&](const lab::Outcome& outcome) {
    return !outcome.files.empty() && outcome.trouble(lab::Trouble::Of::Files) == nullptr &&
           fs::path(outcome.files.front()).filename() != run_file({}, outcome.job.seed).filename();
  };
  const auto first = std::ranges::find_if(outcomes, renamed);
  if (first == outcomes.end()) return;
  const std::string wanted = run_file(output_folder(arguments), first->job.seed).string();
  if (outcomes.size() == 1) {
    note(say({"note: {} holds another run (another controller, other settings or inputs) and stays; this one is {}",
              "nota: {} contiene otra ejecución (otro controlador, otros ajustes u otras entradas) y se queda; esta es "
              "{}"},
             wanted, first->files.front()));
    return;
  }
  note(say({"note: {} of {} runs found another run (another controller, other settings or inputs) under their name, "
            "which stays; {} is {}. For batches to be compared choose a folder for each, with --out",
            "nota: {} de {} ejecuciones hallaron otra ejecución (otro controlador, otros ajustes u otras entradas) con "
            "su nombre, que se queda; {} es {}. Para comparar series elija una carpeta para cada una, con --out"},
           std::ranges::count_if(outcomes, renamed), outcomes.size(), wanted, first->files.front()));
}

/// What runs of one experiment over many seeds share.
lab::BatchOptions batch_of(const RunArguments& arguments, std::vector<ModuleExperience> experience) {
  lab::BatchOptions options;
  options.threads = arguments.threads;
  options.experience = std::move(experience);
  options.stop = interrupted;
  return options;
}

int run_many(const Prepared& prepared, const RunArguments& arguments, const SeedRange& seeds,
             std::vector<ModuleExperience> experience) {
  lab::BatchOptions options = batch_of(arguments, std::move(experience));
  options.keep = [&](const lab::Job& job) {
    lab::Keep keep = keep_of(arguments, job.seed);
    keep.report = keep.catalogue = false;
    keep.experience.clear();
    return keep;
  };
  ProgressLine line(!arguments.json);
  const double start_s = wall_s();
  options.progress = [&](std::size_t done, std::size_t all) {
    line.show(static_cast<double>(done) / static_cast<double>(all),
              say({"{} of {} runs, {:.1f} runs/s", "{} de {} ejecuciones, {:.1f} por segundo"}, done, all,
                  static_cast<double>(done) / (wall_s() - start_s)));
    return true;
  };
  const auto jobs = lab::each_seed(job_of(prepared, arguments, seeds.first), seeds.last);
  const auto outcomes = lab::carry_out_all(prepared, jobs, options);
  if (!outcomes) return complain(outcomes.error());
  int code = kDone;
  for (const lab::Outcome& outcome : *outcomes) code = std::max(code, complain_of(outcome));
  if (!arguments.no_record) {
    if (const auto listed = lab::catalogue(output_folder(arguments), *outcomes, prepared); !listed)
      complain(listed.error());
  }
  tell_names(arguments, *outcomes);
  return std::max(code, print(arguments, *outcomes));
}

/// Every fault, one after the other, each over all seeds.
int run_faults(const Prepared& prepared, const RunArguments& arguments, const SeedRange& seeds,
               std::vector<ModuleExperience> experience) {
  lab::BatchOptions options = batch_of(arguments, std::move(experience));
  ProgressLine line(!arguments.json);
  options.progress = [&](std::size_t done, std::size_t all) {
    line.show(static_cast<double>(done) / static_cast<double>(all),
              say({"{} of {} runs", "{} de {} ejecuciones"}, done, all));
    return !interrupted();
  };
  const auto jobs = lab::each_seed(job_of(prepared, arguments, seeds.first), seeds.last);
  const auto rows = lab::run_fault_matrix(prepared, jobs, options, arguments.faults == "pairs");
  if (!rows) return complain(rows.error());
  const std::string text = arguments.json ? faults_json(*rows) : faults_table(*rows, language());
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? kDone : kOutputFailed;
}

int run_one(const Prepared& prepared, const RunArguments& arguments, double pace) {
  const lab::Job job = job_of(prepared, arguments, arguments.has_seed ? arguments.seed : prepared.experiment.seed);
  lab::Hooks hooks;
  hooks.run.pace = pace;
  hooks.note = note;
  ProgressLine line(!arguments.json);
  const double start_s = wall_s();
  hooks.run.progress = [&](double share) {
    line.show(share, say({"{:.0f}x real time", "{:.0f}x tiempo real"},
                         share * prepared.experiment.duration_s / (wall_s() - start_s)));
    return true;
  };
  hooks.run.stop = interrupted;
  std::unique_ptr<WatchedRun> watched;
  if (arguments.studio) {
    auto opened = WatchedRun::open(prepared, job, hooks);
    if (!opened) return complain(opened.error());
    watched = std::move(*opened);
  }
  const auto outcome = lab::carry_out(prepared, job, keep_of(arguments, job.seed), hooks);
  if (!outcome) return complain(outcome.error());
  const int written = complain_of(*outcome);
  tell_names(arguments, {*outcome});
  if (print(arguments, {*outcome}) != kDone) return kOutputFailed;
  if (!arguments.json) {
    for (const std::string& file : outcome->files) tell({"wrote {}", "escrito {}"}, file);
  }
  if (const Error* lost = outcome->trouble(lab::Trouble::Of::Link)) {
    complain(*lost);
    return kLinkLostCode;
  }
  if (watched) watched->serve_until_interrupted();
  if (written != kDone) return written;
  return outcome->verdict == Verdict::Failed ? kRobotFailed : kDone;
}

int run_command(const RunArguments& arguments) {
  Problems problems;
  const auto overrides = overrides_of(arguments, problems);
  const auto pace = pace_of(arguments.pace);
  if (!pace) problems.add(pace.error());
  std::optional<SeedRange> seeds;
  if (!arguments.seeds.empty()) {
    if (auto range = seeds_of(arguments.seeds)) {
      seeds = *range;
    } else {
      problems.add(range.error());
    }
  }
  if (!problems.empty()) return complain(problems);
  const auto prepared = prepare(arguments.experiment, overrides, problems);
  if (!prepared) return complain(problems);
  catch_interrupts();
  if (arguments.faults.empty() && !seeds) return run_one(*prepared, arguments, *pace);
  auto experience = lab::read_experience(arguments.experience, prepared->controller);
  if (!experience) return complain(experience.error());
  for (const Sentence& one : experience->notes) note(one);
  if (!arguments.faults.empty()) {
    return run_faults(*prepared, arguments, seeds.value_or(SeedRange{1, kFaultSeeds}),
                      std::move(experience->remembered));
  }
  return run_many(*prepared, arguments, *seeds, std::move(experience->remembered));
}

}  // namespace

void add_run(CLI::App& program, int& code) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = program.add_subcommand("run", "Carry out an experiment: once, or once for each seed");
  command->add_option("experiment", arguments->experiment, "Folder or experiment.toml")->required();
  command->add_option("--set", arguments->set, "key=value: changes a key of the files the experiment names")
      ->allow_extra_args(false);
  auto* seed = command->add_option("--seed", arguments->seed, "Seed of the run; default: the experiment's");
  command->add_option("--seeds", arguments->seeds, "A..B: every seed of the range, in parallel")->excludes(seed);
  command
      ->add_option("--faults", arguments->faults,
                   "matrix: every single fault over the seeds (default 1..20), as a table; pairs: every two as well")
      ->check(CLI::IsMember({"matrix", "pairs"}))
      ->excludes(seed);
  command->add_option(
      "--robot", arguments->robot,
      "tcp://HOST:PORT, serial:///dev/ttyUSB0?baud=115200 or serial+tcp://HOST:PORT (a serial line behind "
      "a socket): drive the robot there");
  command->add_option("--threads", arguments->threads, "Threads for --seeds; default: one for each processor")
      ->check(CLI::Range(1, 256));
  auto* pace = command->add_option("--pace", arguments->pace, "max, or a multiple of real time: 1x, 0.5x, 20x");
  command->add_option("--out", arguments->out, "Folder for run files and report; default: runs/NAME");
  command->add_option("--experience", arguments->experience, "Start with what this file remembers, and add to it");
  command->add_flag("--json", arguments->json, "Print one JSON object and nothing else");
  command->add_flag("--no-record", arguments->no_record, "Write no run files");
  command
      ->add_flag("--studio", arguments->studio,
                 "Show the run in a browser while it goes, at real time unless --pace says otherwise; ctrl-C ends")
      ->excludes("--seeds")
      ->excludes("--faults");
  command->add_flag("--no-report", arguments->no_report, "Write no report");
  command->footer(
      "Examples:\n"
      "  ganglion run experiments/nimrod --seed 7 --pace 1x\n"
      "  ganglion run experiments/nimrod --set controller=experiments/nimrod/controller.listing.toml\n"
      "  ganglion run experiments/nimrod --set controller.acting.escape.trigger_range_m=0.15 --seeds 1..20\n"
      "  ganglion run experiments/nimrod --faults matrix --seeds 1..100\n"
      "  ganglion run experiments/nimrod --robot tcp://127.0.0.1:7007\n"
      "Exit codes: 0 the robot succeeded or was not judged (with --seeds: all runs were carried out), 1 it failed, 2 "
      "bad input, 3 the link to the robot was lost.");
  command->callback([arguments, seed, pace, &code] {
    if (arguments->studio && pace->count() == 0) arguments->pace = "1x";
    arguments->has_seed = seed->count() > 0;
    code = run_command(*arguments);
  });
}

}  // namespace ganglion
