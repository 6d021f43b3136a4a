#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "ganglion/module/exhibit.h"
#include "ganglion/record/run_sink.h"

namespace ganglion {

/// Writes what a component shows, when it differs from what it showed last: maps as foxglove.Grid with one byte per
/// layer and cell, paths as ganglion.Path.
class ExhibitWriter final : public Exhibition {
 public:
  /// Topics are "/robot0/map/router" and "/robot0/route/router". `shown` keeps hashes between calls.
  ExhibitWriter(RunSink& recorder, std::map<std::string, std::uint64_t>& shown, std::string robot,
                std::string component, double time_s);
  void grid(const GridExhibit& grid) override;
  void path(std::string_view name, std::span<const Vector2> points) override;

 private:
  bool changed(const std::string& topic, std::uint64_t hash);

  RunSink& recorder_;
  std::map<std::string, std::uint64_t>& shown_;
  std::string robot_;
  std::string component_;
  double time_s_;
};

}  // namespace ganglion
