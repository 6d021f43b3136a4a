#pragma once

#include "ganglion/exhibit/exhibit.h"
#include "ganglion/record/exhibit/keep.h"
#include "ganglion/record/exhibit/track.h"

namespace ganglion {

/// Shows two fields of three layers, one in the world and one with axes of its own, a curve, bars, marks of every form
/// in the world and in a frame that recorded columns lead, and a network. `stage` 0, 1, 2... moves what can move.
class ShowsAll final : public Exhibitor {
 public:
  void show(Exhibition& to) const override;
  int stage = 0;

 private:
  void show_fields(Exhibition& to) const;
  void show_marks(Exhibition& to) const;
};

/// Gathers what is shown into tracks, as a run file would give them back.
class KeepsShown final : public Exhibition {
 public:
  explicit KeepsShown(ExhibitOwner owner) : owner_(std::move(owner)) {}
  bool lacks(std::string_view, std::uint64_t) override { return true; }
  void frame(const FrameExhibit& one) override { add(one.name, shown::keep(one)); }
  void field(const FieldExhibit& one) override { add(one.name, shown::keep(one)); }
  void curve(const CurveExhibit& one) override { add(one.name, shown::keep(one)); }
  void bars(const BarExhibit& one) override { add(one.name, shown::keep(one)); }
  void marks(const MarkExhibit& one) override { add(one.name, shown::keep(one)); }
  void network(const NetworkExhibit& one) override { add(one.name, shown::keep(one)); }

  double time_s = 0;
  std::vector<ExhibitTrack> tracks;

 private:
  void add(std::string_view name, std::optional<shown::Exhibit> exhibit);
  ExhibitOwner owner_;
};

}  // namespace ganglion
