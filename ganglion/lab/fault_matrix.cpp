#include "ganglion/lab/fault_matrix.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ganglion::lab {
namespace {

constexpr double kLate_s = 0.5, kAllLate_s = 0.2, kLostShare = 0.2, kLostPower = 0.5;

Fault fault(std::string target, FaultKind kind, double amount = 0, std::string with = "") {
  Fault made;
  made.target = std::move(target);
  made.kind = kind;
  made.amount = amount;
  made.with = std::move(with);
  return made;
}

std::string device_of(const std::string& channel) { return channel.substr(0, channel.find('.')); }

/// The devices whose channels the controller reads, in the robot's order, and those channels.
struct Used {
  std::string device;
  std::vector<const SensationChannel*> channels;
};

std::vector<Used> used_devices(const Prepared& prepared) {
  std::set<std::string> wired;
  for (const ComponentModel& component : prepared.controller.components)
    if (!component.channel.empty()) wired.insert(component.channel);
  const auto tasks = prepared.application->tasks();  // their channels are no device's: nothing there can break
  std::vector<Used> used;
  for (const SensationChannel& channel : prepared.application->description().sensations) {
    const std::string device = device_of(channel.name);
    if (!wired.contains(channel.name) || std::ranges::count(tasks, device) > 0) continue;
    if (used.empty() || used.back().device != device) used.push_back({device, {}});
    used.back().channels.push_back(&channel);
  }
  return used;
}

/// Bias that is worth a test, in the channel's unit; 0 for what is no measure.
double bias_of(const SensationChannel& channel) {
  if (channel.type == ValueType::Discrete) return 0;
  if (channel.unit == "rad") return Angle::from_deg(20).rad();
  if (channel.unit == "m") return 0.10;
  const double range = channel.max - channel.min;
  return std::isfinite(range) ? 0.05 * range : 0;
}

bool alike(const Used& a, const Used& b) {
  return std::ranges::equal(a.channels, b.channels, [](const SensationChannel* one, const SensationChannel* other) {
    return one->unit == other->unit && one->size() == other->size() && one->type == other->type;
  });
}

void add_sensor_faults(const Used& used, std::vector<Fault>& faults) {
  faults.push_back(fault(used.device, FaultKind::Dead));
  faults.push_back(fault(used.device, FaultKind::Stuck));
  for (const SensationChannel* channel : used.channels) {
    const double bias = bias_of(*channel);
    if (bias == 0) continue;
    faults.push_back(fault(channel->name, FaultKind::Biased, bias));
    faults.push_back(fault(channel->name, FaultKind::Noisy, bias / 2));
  }
  faults.push_back(fault(used.device, FaultKind::Late, kLate_s));
}

std::vector<Fault> single_faults(const Prepared& prepared) {
  std::vector<Fault> faults;
  const std::vector<Used> used = used_devices(prepared);
  for (const Used& one : used) add_sensor_faults(one, faults);
  for (std::size_t a = 0; a < used.size(); ++a)
    for (std::size_t b = a + 1; b < used.size(); ++b)
      for (std::size_t c = 0; c < used[a].channels.size() && alike(used[a], used[b]); ++c)
        faults.push_back(fault(used[a].channels[c]->name, FaultKind::Swapped, 0, used[b].channels[c]->name));
  for (const CommandChannel& command : prepared.application->description().commands)
    for (const CommandElement& element : command.elements)
      faults.push_back(fault(command.name + "." + element.name, FaultKind::Weak, kLostPower));
  for (const char* all : {"frames", "commands"}) {
    faults.push_back(fault(all, FaultKind::Lost, kLostShare));
    faults.push_back(fault(all, FaultKind::Late, kAllLate_s));
  }
  return faults;
}

/// The same signals, or a device and its own channel: one fault would hide the other.
bool overlap(const std::string& a, const std::string& b) { return a == b || device_of(a) == b || a == device_of(b); }

FaultRow row_of(const FaultCase& one, const Experiment& experiment, const std::vector<Outcome>& outcomes) {
  FaultRow row{
      .name = one.name,
      .runs = outcomes.size(),
      .succeeded = static_cast<std::size_t>(std::ranges::count(outcomes, Verdict::Succeeded, &Outcome::verdict)),
      .met = {},
      .quartiles = quartiles(outcomes)};
  for (const Criterion& criterion : experiment.success) {
    const auto met = std::ranges::count_if(outcomes, [&](const Outcome& run) { return criterion.met(run.figures); });
    row.met.emplace_back(criterion.text(), static_cast<std::size_t>(met));
  }
  return row;
}

}  // namespace

Result<std::vector<FaultCase>> fault_cases(const Prepared& prepared, bool pairs) {
  std::vector<FaultCase> cases = {{"healthy", {}}};
  const std::vector<Fault> singles = single_faults(prepared);
  if (singles.size() >= kMaxFaultCases)
    return fail(
        ErrorCode::TooLarge,
        {"the sensors that the controller uses allow {} single faults; the limit is {} cases: write those of "
         "interest as [[fault]] in the experiment",
         "los sensores que usa el controlador admiten {} averías simples; el límite es de {} casos: escriba las que "
         "interesen como [[fault]] en el experimento"},
        singles.size(), kMaxFaultCases);
  for (const Fault& one : singles) cases.push_back({one.text(), {one}});
  for (std::size_t a = 0; pairs && a < singles.size(); ++a) {
    for (std::size_t b = a + 1; b < singles.size(); ++b) {
      if (overlap(singles[a].target, singles[b].target)) continue;
      if (cases.size() == kMaxFaultCases)
        return fail(ErrorCode::TooLarge,
                    {"{} single faults make more than {} cases in pairs: try them one by one (--faults matrix), and "
                     "write the pairs of interest as [[fault]] in the experiment",
                     "{} averías simples dan más de {} casos por parejas: pruébelas una por una (--faults matrix), y "
                     "escriba las parejas que interesen como [[fault]] en el experimento"},
                    singles.size(), kMaxFaultCases);
      cases.push_back({singles[a].text() + " + " + singles[b].text(), {singles[a], singles[b]}});
    }
  }
  return cases;
}

Result<std::vector<FaultRow>> run_fault_matrix(const Prepared& prepared, std::span<const Job> jobs,
                                               const BatchOptions& options, bool pairs) {
  const auto made = fault_cases(prepared, pairs);
  if (!made) return tl::unexpected<Error>(made.error());
  const std::vector<FaultCase>& cases = *made;
  std::vector<FaultRow> rows;
  bool stopped = false;
  for (const FaultCase& one : cases) {
    std::vector<Job> faulty(jobs.begin(), jobs.end());
    for (Job& job : faulty) job.faults.insert(job.faults.end(), one.faults.begin(), one.faults.end());
    BatchOptions batch = options;
    batch.progress = [&](std::size_t done, std::size_t) {
      stopped = options.progress && !options.progress(rows.size() * jobs.size() + done, cases.size() * jobs.size());
      return !stopped;
    };
    const auto outcomes = carry_out_all(prepared, faulty, batch);
    if (!outcomes) return tl::unexpected<Error>(outcomes.error());
    if (stopped) break;
    rows.push_back(row_of(one, prepared.experiment, *outcomes));
  }
  return rows;
}

}  // namespace ganglion::lab
