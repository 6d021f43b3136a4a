#include "ganglion/run/measure_list.h"

#include <algorithm>
#include <cmath>

#include "ganglion/kinds/kinds.h"

namespace ganglion {
namespace {

std::vector<const MeasureKind*> in_order() {
  const auto kinds = measure_kinds();
  std::vector<const MeasureKind*> list(kinds.begin(), kinds.end());
  std::stable_sort(list.begin(), list.end(), [](const auto* a, const auto* b) { return a->order < b->order; });
  return list;
}

}  // namespace

std::vector<MeasuredSignal> measured_signals(const Controller& controller) {
  std::vector<MeasuredSignal> list;
  for (const Signal& signal : controller.signals()) list.push_back({signal.name, signal.unit, signal.meaning});
  return list;
}

std::vector<Figure> figures_in(const MeasureScope& scope) {
  std::vector<Figure> all;
  for (const MeasureKind* kind : in_order()) {
    for (Figure& figure : kind->figures(scope)) all.push_back(std::move(figure));
  }
  return all;
}

MeasureList::MeasureList(const MeasureScope& scope) {
  for (const MeasureKind* kind : in_order()) {
    std::vector<Figure> figures = kind->figures(scope);
    if (!figures.empty()) entries_.push_back({kind->make(scope), std::move(figures)});
  }
}

void MeasureList::begin(const Moment& start, const Unhindered* unhindered) {
  for (Entry& entry : entries_) entry.measure->begin(start, unhindered);
}

void MeasureList::update(const Moment& now) {
  for (Entry& entry : entries_) entry.measure->update(now);
}

Measures MeasureList::listed() const {
  Measures result;
  std::vector<double> values;
  for (const Entry& entry : entries_) {
    values.assign(entry.figures.size(), std::numeric_limits<double>::quiet_NaN());
    entry.measure->report(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Figure& figure = entry.figures[i];
      if (figure.listed && !(figure.sparse && std::isnan(values[i]))) result.emplace_back(figure.name, values[i]);
    }
  }
  return result;
}

Measures MeasureList::of(const std::vector<std::string>& names) const {
  Measures result;
  for (const std::string& name : names) {
    for (const Entry& entry : entries_) {
      const auto found = std::ranges::find(entry.figures, name, &Figure::name);
      if (found == entry.figures.end()) continue;
      const auto index = static_cast<std::size_t>(found - entry.figures.begin());
      std::optional<double> value = entry.measure->value(index);
      if (!value) {
        std::vector<double> values(entry.figures.size(), std::numeric_limits<double>::quiet_NaN());
        entry.measure->report(values);
        value = values[index];
      }
      result.emplace_back(name, *value);
    }
  }
  return result;
}

}  // namespace ganglion
