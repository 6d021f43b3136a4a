#include "ganglion/measure/followed.h"

#include <limits>

namespace ganglion {
namespace {

class LastValues final : public Measure {
 public:
  explicit LastValues(std::vector<std::size_t> channels)
      : channels_(std::move(channels)), values_(channels_.size(), std::numeric_limits<double>::quiet_NaN()) {}
  void begin(const Moment& start, const Unhindered*) override { update(start); }
  void update(const Moment& now) override {
    if (now.truth.empty()) return;
    for (std::size_t i = 0; i < channels_.size(); ++i) values_[i] = now.truth[channels_[i]];
  }
  void report(std::span<double> figures) const override {
    for (std::size_t i = 0; i < values_.size(); ++i) figures[i] = values_[i];
  }

 private:
  std::vector<std::size_t> channels_;
  std::vector<double> values_;
};

}  // namespace

std::vector<Figure> followed_figures(const MeasureScope& scope, std::span<const Followed> list) {
  std::vector<Figure> figures;
  for (const Followed& one : list) {
    if (!scope.truth_index(one.channel)) continue;
    figures.push_back(
        {.name = std::string(one.name), .unit = std::string(one.unit), .title = say({"{}", "{}"}, one.title)});
  }
  return figures;
}

std::unique_ptr<Measure> make_followed(const MeasureScope& scope, std::span<const Followed> list) {
  std::vector<std::size_t> channels;
  for (const Followed& one : list) {
    if (const auto channel = scope.truth_index(one.channel)) channels.push_back(*channel);
  }
  return std::make_unique<LastValues>(std::move(channels));
}

}  // namespace ganglion
