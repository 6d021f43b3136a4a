#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ganglion/measure/measure.h"

namespace ganglion {
namespace {

/// Outcomes as the ledger of goals has them.
enum Outcome { kReached = 1, kWithdrawn = 2, kTimedOut = 3, kReplaced = 4 };

struct Columns {
  std::size_t ledger, reachable, outcome, travelled, shortest, steered;
};

/// The first ledger that has what is asked for: whatever task keeps it.
std::optional<Columns> columns_of(const MeasureScope& scope) {
  for (std::size_t n = 0; n < scope.ledgers.size(); ++n) {
    const LedgerForm& form = scope.ledgers[n];
    const auto reachable = form.column("reachable"), outcome = form.column("outcome"),
               travelled = form.column("travelled_m"), shortest = form.column("static_shortest_m"),
               steered = form.column("steered_shortest_m");
    if (!reachable || !outcome || !travelled || !shortest || !steered) continue;
    return Columns{n, *reachable, *outcome, *travelled, *shortest, *steered};
  }
  return std::nullopt;
}

struct GoalFigure {
  std::string_view name;
  Text title;
  bool listed = true;
  bool sparse = false;
};
constexpr std::array kFigures = {
    GoalFigure{"goals_set", {"goals set", "objetivos fijados"}},
    GoalFigure{"goals_reached", {"goals reached", "objetivos alcanzados"}},
    GoalFigure{"goals_withdrawn", {"goals that the controller gave up", "objetivos que el controlador abandonó"}},
    GoalFigure{"goals_timed_out", {"goals for which patience ended", "objetivos para los que se acabó la paciencia"}},
    GoalFigure{"goals_unreachable", {"goals to which no way led when set", "objetivos sin camino cuando se fijaron"}},
    GoalFigure{"goals_missed",
               {"goals within reach that were neither reached nor replaced",
                "objetivos alcanzables que ni se alcanzaron ni se sustituyeron"}},
    GoalFigure{"goals_replaced", {"goals that somebody replaced", "objetivos que alguien sustituyó"}, true, true},
    GoalFigure{"unreachable_withdrawn",
               {"unreachable goals that were given up", "objetivos inalcanzables que se abandonaron"}},
    GoalFigure{"travel_ratio_first",
               {"way of the first five reached over the shortest", "camino de los cinco primeros frente al más corto"}},
    GoalFigure{"travel_ratio_last",
               {"way of the last five reached over the shortest", "camino de los cinco últimos frente al más corto"}},
    GoalFigure{"travel_ratio_late",
               {"way of the later half reached over the shortest", "camino de la segunda mitad frente al más corto"}},
    GoalFigure{"travel_ratio_first_steered",
               {"the same of the first five, over the shortest of one that steers",
                "lo mismo de los cinco primeros, frente al más corto de uno con dirección"}},
    GoalFigure{"travel_ratio_last_steered",
               {"the same of the last five, over the shortest of one that steers",
                "lo mismo de los cinco últimos, frente al más corto de uno con dirección"}},
    GoalFigure{"travel_ratio_late_steered",
               {"the same of the later half, over the shortest of one that steers",
                "lo mismo de la segunda mitad, frente al más corto de uno con dirección"}},
    GoalFigure{"goals_done", {"1 once every goal has its outcome", "1 una vez que cada objetivo acabó"}, false},
};

/// Of the goals that a task set: how many became what, and the ways to them against the shortest there were, movers aside.
class Goals final : public Measure {
 public:
  explicit Goals(const Columns& columns) : columns_(columns) {}
  void begin(const Moment& start, const Unhindered*) override { goals_ = start.ledgers[columns_.ledger]; }
  void update(const Moment& now) override { goals_ = now.ledgers[columns_.ledger]; }

  void report(std::span<double> figures) const override {
    if (goals_ == nullptr) {
      std::fill(figures.begin(), figures.end(), std::numeric_limits<double>::quiet_NaN());
      return;
    }
    const double replaced = count([this](std::size_t row) { return outcome(row) == kReplaced; });
    const auto of = [this](Outcome wanted) {
      return count([this, wanted](std::size_t row) { return outcome(row) == wanted; });
    };
    std::size_t at = 0;
    figures[at++] = static_cast<double>(goals_->rows());
    figures[at++] = of(kReached);
    figures[at++] = of(kWithdrawn);
    figures[at++] = of(kTimedOut);
    figures[at++] = count([this](std::size_t row) { return !reachable(row); });
    figures[at++] = count(
        [this](std::size_t row) { return reachable(row) && outcome(row) != kReached && outcome(row) != kReplaced; });
    figures[at++] = replaced > 0 ? replaced : std::numeric_limits<double>::quiet_NaN();
    figures[at++] = count([this](std::size_t row) { return !reachable(row) && outcome(row) == kWithdrawn; });
    for (const std::size_t yardstick : {columns_.shortest, columns_.steered}) {
      report_ratios(yardstick, figures.subspan(at, 3));
      at += 3;
    }
    figures[at] = goals_->done() ? 1 : 0;
  }
  std::optional<double> value(std::size_t figure) const override {
    if (goals_ == nullptr || kFigures[figure].name != "goals_done") return std::nullopt;
    return goals_->done() ? 1 : 0;
  }

 private:
  template <class Which>
  double count(Which which) const {
    double number = 0;
    for (std::size_t row = 0; row < goals_->rows(); ++row) number += which(row) ? 1 : 0;
    return number;
  }
  int outcome(std::size_t row) const { return static_cast<int>(goals_->at(row, columns_.outcome)); }
  bool reachable(std::size_t row) const { return goals_->at(row, columns_.reachable) != 0; }

  void report_ratios(std::size_t yardstick, std::span<double> figures) const {
    std::vector<std::size_t> reached;
    for (std::size_t row = 0; row < goals_->rows(); ++row) {
      if (outcome(row) == kReached) reached.push_back(row);
    }
    const std::span<const std::size_t> all(reached);
    const std::size_t few = std::min<std::size_t>(5, all.size());
    figures[0] = ratio(all.first(few), yardstick);
    figures[1] = ratio(all.last(few), yardstick);
    figures[2] = ratio(all.subspan(all.size() / 2), yardstick);
  }

  double ratio(std::span<const std::size_t> rows, std::size_t yardstick) const {
    double travelled_m = 0, shortest_m = 0;
    for (const std::size_t row : rows) {
      const double way_m = goals_->at(row, yardstick);
      if (!std::isfinite(way_m)) continue;
      travelled_m += goals_->at(row, columns_.travelled);
      shortest_m += way_m;
    }
    return shortest_m > 0 ? travelled_m / shortest_m : std::numeric_limits<double>::quiet_NaN();
  }

  Columns columns_;
  const Ledger* goals_ = nullptr;
};

}  // namespace

extern constinit const MeasureKind goals_kind{
    .descriptor =
        {.component_class = ComponentClass::Measure,
         .name = "Goals",
         .summary = {"What became of a task's goals: goals_set, goals_reached, goals_missed, travel_ratio_late "
                     "and others, and goals_done for stop rules",
                     "Qué fue de los objetivos de un entrenador: goals_set, goals_reached, goals_missed, "
                     "travel_ratio_late y otras, y goals_done para parar"},
         .source = "ours"},
    .order = 8,
    .figures =
        [](const MeasureScope& scope) {
          std::vector<Figure> figures;
          if (!columns_of(scope)) return figures;
          for (const GoalFigure& one : kFigures) {
            figures.push_back({.name = std::string(one.name),
                               .unit = "",
                               .title = say({"{}", "{}"}, one.title),
                               .listed = one.listed,
                               .sparse = one.sparse});
          }
          return figures;
        },
    .make = [](const MeasureScope& scope) -> std::unique_ptr<Measure> {
      return std::make_unique<Goals>(*columns_of(scope));
    }};

}  // namespace ganglion
