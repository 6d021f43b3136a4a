#include "ganglion/measure/measure.h"

namespace ganglion {
namespace {

struct Candidate {
  std::string name;
  std::size_t signal = 0;
};

std::vector<Candidate> candidates_of(const MeasureScope& scope) {
  std::vector<Candidate> list;
  for (std::size_t i = 0; i < scope.signals.size(); ++i) {
    if (scope.signals[i].meaning != Meaning::Share) continue;
    const std::string& name = scope.signals[i].name;
    list.push_back({name.substr(name.rfind('.') + 1), i});
  }
  return list;
}

/// How much of the time each candidate of a coordinator drove.
class Shares final : public Measure {
 public:
  explicit Shares(std::vector<Candidate> candidates) : candidates_(std::move(candidates)), sums_(candidates_.size()) {}
  void update(const Moment& now) override {
    ++ticks_;
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += now.signals[candidates_[i].signal];
  }
  void report(std::span<double> figures) const override {
    for (std::size_t i = 0; i < sums_.size(); ++i) figures[i] = ticks_ > 0 ? sums_[i] / static_cast<double>(ticks_) : 0;
  }

 private:
  std::vector<Candidate> candidates_;
  std::vector<double> sums_;
  std::size_t ticks_ = 0;
};

}  // namespace

extern constinit const MeasureKind share_kind{
    .descriptor = {.component_class = ComponentClass::Measure,
                   .name = "Share",
                   .summary = {"How much of the time each candidate of a coordinator drove: <id>_share",
                               "Cuánto del tiempo condujo cada candidato de un coordinador: <id>_share"},
                   .source = "ours"},
    .order = 7,
    .figures =
        [](const MeasureScope& scope) {
          std::vector<Figure> figures;
          for (const Candidate& candidate : candidates_of(scope)) {
            figures.push_back({.name = candidate.name + "_share",
                               .unit = "",
                               .title = say({"share of the time that {} drove", "parte del tiempo en que condujo {}"},
                                            candidate.name)});
          }
          return figures;
        },
    .make = [](const MeasureScope& scope) -> std::unique_ptr<Measure> {
      return std::make_unique<Shares>(candidates_of(scope));
    }};

}  // namespace ganglion
