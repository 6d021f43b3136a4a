#include "results_reader.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "ganglion/base/file.h"
#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"
#include "ganglion/lab/outcome.h"
#include "ganglion/record/catalogue.h"
#include "ganglion/run/inputs.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxRuns = 1'000'000;  // as many as run --seeds carries out

tl::unexpected<Error> not_results(const std::string& file, const Sentence& why) {
  return fail_at({file}, ErrorCode::BadType,
                 {"{}; the file shall be what ganglion run --json prints",
                  "{}; el archivo debe ser lo que imprime ganglion run --json"},
                 why);
}

Result<std::vector<report::BatchRun>> runs_of_json(const std::string& file) {
  const auto text = read_file(file);
  if (!text) return tl::unexpected<Error>(text.error());
  const Json all = Json::parse(*text, nullptr, false);
  if (all.is_discarded())
    return fail_at({file}, ErrorCode::Syntax,
                   {"no JSON; write it with ganglion run --json", "no es JSON; escríbalo con ganglion run --json"});
  const auto runs = all.is_object() ? all.find("runs") : all.end();
  if (runs == all.end() || !runs->is_array())
    return not_results(file, say({"there is no list \"runs\"", "no hay ninguna lista \"runs\""}));
  std::vector<report::BatchRun> read;
  for (const Json& run : *runs) {
    auto outcome = lab::read_outcome(run, fmt::format("runs[{}]", read.size()));
    if (!outcome) return not_results(file, outcome.error().what);
    read.push_back({outcome->verdict, std::move(outcome->figures)});
  }
  return read;
}

/// All that went into a run but its seed and what it knew: its files, and what --set changed.
std::uint64_t settings_of(const fs::path& file) {
  const auto run = RunFile::read_summary(file, Recover::Yes);
  if (!run) return 0;
  std::uint64_t hash = hash_name(run->info.name);
  for (const mcap::Attachment& one : run->attachments) {
    if (one.name.starts_with("input/") || one.name.starts_with("builtin/")) hash = combine(hash, hash_name(one.bytes));
  }
  const auto inputs = AttachedFiles::of(*run);
  if (!inputs) return hash;
  for (const config::Override& one : (*inputs)->overrides())
    hash = combine(hash, hash_name(one.path + "=" + one.value));
  return hash;
}

/// A batch is the runs of one controller with one set of settings, each seed once; by seed.
Result<void> check_one_batch(const std::string& folder, std::span<const RunSummary> runs) {
  std::map<std::uint64_t, std::vector<std::string>> kinds;
  for (const RunSummary& run : runs) {
    if (run.finished) kinds[settings_of(fs::path(folder) / run.file)].push_back(run.file);
  }
  if (kinds.size() > 1) {
    std::vector<std::string> told;
    for (const auto& [kind, files] : kinds) told.push_back(fmt::format("{} ({})", files.front(), files.size()));
    return fail_at({folder}, ErrorCode::BadParameter,
                   {"holds runs of {} controllers or settings, which are no batch: {}; give each a folder of its own",
                    "contiene ejecuciones de {} controladores o ajustes, que no son una serie: {}; dé a cada uno una "
                    "carpeta propia"},
                   kinds.size(), join(told, ", "));
  }
  const auto twice = std::ranges::adjacent_find(runs, [](const RunSummary& one, const RunSummary& next) {
    return one.seed == next.seed && one.episode == next.episode && one.finished && next.finished;
  });
  if (twice == runs.end()) return {};
  return fail_at({folder}, ErrorCode::BadParameter,
                 {"holds seed {} twice, {} and {}: no batch; give each a folder of its own",
                  "contiene la semilla {} dos veces, {} y {}: no es una serie; dé a cada una una carpeta propia"},
                 twice->seed, twice->file, std::next(twice)->file);
}

Result<std::vector<report::BatchRun>> runs_of_folder(const std::string& folder) {
  auto catalogue = RunCatalogue::open(folder);
  if (!catalogue) return tl::unexpected<Error>(catalogue.error());
  if (const auto rebuilt = catalogue->rebuild(); !rebuilt) return tl::unexpected<Error>(rebuilt.error());
  RunFilter filter;
  filter.sort_by = "seed";
  filter.descending = false;
  filter.limit = kMaxRuns;
  const auto runs = catalogue->list(filter);
  if (!runs) return tl::unexpected<Error>(runs.error());
  if (auto one = check_one_batch(folder, *runs); !one) return tl::unexpected<Error>(one.error());
  std::vector<report::BatchRun> read;
  for (const RunSummary& run : *runs) read.push_back({run.finished ? run.verdict : Verdict::Failed, run.measures});
  return read;
}

}  // namespace

Result<report::NamedBatch> read_batch(const std::string& argument) {
  const auto equals = argument.find('=');
  const bool named = equals != std::string::npos && !fs::exists(argument);
  const std::string path = named ? argument.substr(equals + 1) : argument;
  if (!fs::exists(path)) {
    return fail_at(
        {path}, ErrorCode::NotFound,
        {"there is no such file or folder; name what run --json printed, or a folder of run files",
         "no existe ese archivo ni esa carpeta; nombre lo que imprimió run --json, o una carpeta de ejecuciones"});
  }
  auto runs = fs::is_directory(path) ? runs_of_folder(path) : runs_of_json(path);
  if (!runs) return tl::unexpected<Error>(runs.error());
  if (runs->empty())
    return fail_at({path}, ErrorCode::NotFound, {"there are no runs to compare", "no hay ejecuciones que comparar"});
  const fs::path normal = fs::absolute(path).lexically_normal();
  const std::string last = normal.has_filename() ? normal.stem().string() : normal.parent_path().filename().string();
  return report::NamedBatch{named ? argument.substr(0, equals) : last, std::move(*runs)};
}

}  // namespace ganglion
