#include "ganglion/graph/loops.h"

#include <algorithm>

namespace ganglion {
namespace {

using Edges = std::vector<std::vector<int>>;  // for each component those whose values it takes

Edges edges_of(const ControllerModel& model) {
  Edges from(model.components.size());
  for (std::size_t i = 0; i < model.components.size(); ++i) {
    for (const Wire& wire : model.components[i].wires) {
      for (const Source& source : wire.sources) {
        if (source.kind == Source::Kind::Output) from[i].push_back(source.component);
      }
    }
  }
  return from;
}

class LoopFinder {
 public:
  explicit LoopFinder(const Edges& edges)
      : edges_(edges),
        seen_(edges.size(), -1),
        low_(edges.size(), 0),
        next_edge_(edges.size(), 0),
        loop_(edges.size(), -1) {}

  std::vector<int> run() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (seen_[i] < 0) search(i);
    }
    return std::move(loop_);
  }

 private:
  void open(std::size_t at) {
    seen_[at] = low_[at] = count_++;
    path_.push_back(at);
    undecided_.push_back(at);
  }

  void search(std::size_t start) {
    open(start);
    while (!path_.empty()) {
      const std::size_t at = path_.back();
      if (next_edge_[at] < edges_[at].size()) {
        const auto to = static_cast<std::size_t>(edges_[at][next_edge_[at]++]);
        if (seen_[to] < 0) {
          open(to);
        } else if (loop_[to] < 0) {
          low_[at] = std::min(low_[at], seen_[to]);
        }
        continue;
      }
      path_.pop_back();
      if (!path_.empty()) low_[path_.back()] = std::min(low_[path_.back()], low_[at]);
      if (low_[at] == seen_[at]) close(at);
    }
  }

  /// Nothing reached from here leads further back: what is undecided since is one loop.
  void close(std::size_t at) {
    std::size_t member = 0;
    do {
      member = undecided_.back();
      undecided_.pop_back();
      loop_[member] = static_cast<int>(at);
    } while (member != at);
  }

  const Edges& edges_;
  std::vector<int> seen_, low_;
  std::vector<std::size_t> next_edge_;
  std::vector<int> loop_;
  std::vector<std::size_t> path_, undecided_;
  int count_ = 0;
};

}  // namespace

std::vector<int> loops_of(const ControllerModel& model) {
  const Edges edges = edges_of(model);
  return LoopFinder(edges).run();
}

}  // namespace ganglion
