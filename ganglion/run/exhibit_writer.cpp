#include "ganglion/run/exhibit_writer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ganglion/base/base64.h"
#include "ganglion/base/hash.h"

namespace ganglion {
namespace {

std::uint8_t byte_of(float value) noexcept {
  return std::isnan(value) ? 0 : static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
}

std::string fields_json(const GridExhibit& grid) {
  std::string fields;
  for (std::size_t i = 0; i < grid.layers.size(); ++i) {
    fields += fmt::format("{}{{\"name\":\"{}\",\"offset\":{},\"type\":1}}", i > 0 ? "," : "", grid.layers[i].name, i);
  }
  return fields;
}

}  // namespace

ExhibitWriter::ExhibitWriter(RunSink& recorder, std::map<std::string, std::uint64_t>& shown, std::string robot,
                             std::string component, double time_s)
    : recorder_(recorder), shown_(shown), robot_(std::move(robot)), component_(std::move(component)), time_s_(time_s) {}

bool ExhibitWriter::changed(const std::string& topic, std::uint64_t hash) {
  const auto [found, fresh] = shown_.try_emplace(topic, hash);
  if (!fresh && found->second == hash) return false;
  found->second = hash;
  return true;
}

void ExhibitWriter::grid(const GridExhibit& grid) {
  const std::size_t cells = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  const std::size_t layers = grid.layers.size();
  std::vector<std::uint8_t> bytes(cells * layers);
  for (std::size_t layer = 0; layer < layers; ++layer) {
    for (std::size_t i = 0; i < cells; ++i) bytes[i * layers + layer] = byte_of(grid.layers[layer].values[i]);
  }
  std::uint64_t hash = combine(hash_bytes(std::as_bytes(std::span(bytes))), static_cast<std::uint64_t>(grid.columns));
  hash = combine(hash, canonical_bits(grid.origin.x) ^ mix(canonical_bits(grid.origin.y)));
  const std::string topic = fmt::format("/{}/map/{}", robot_, component_);
  if (!changed(topic, hash)) return;
  const std::string json = fmt::format(
      "{{\"timestamp\":{{\"sec\":{},\"nsec\":{}}},\"frame_id\":\"world\","
      "\"pose\":{{\"position\":{{\"x\":{},\"y\":{},\"z\":0}},\"orientation\":{{\"x\":0,\"y\":0,\"z\":0,\"w\":1}}}},"
      "\"column_count\":{},\"cell_size\":{{\"x\":{},\"y\":{}}},\"row_stride\":{},\"cell_stride\":{},"
      "\"fields\":[{}],\"data\":\"{}\"}}",
      static_cast<long>(time_s_), static_cast<long>((time_s_ - std::floor(time_s_)) * 1e9), grid.origin.x,
      grid.origin.y, grid.columns, grid.cell_m, grid.cell_m, static_cast<std::size_t>(grid.columns) * layers, layers,
      fields_json(grid), base64(bytes));
  recorder_.write_json(topic, "foxglove.Grid", time_s_, json);
}

void ExhibitWriter::path(std::string_view name, std::span<const Vector2> points) {
  std::string list;
  for (const Vector2 point : points)
    list += fmt::format("{}[{:.4g},{:.4g}]", list.empty() ? "" : ",", point.x, point.y);
  const std::string topic = fmt::format("/{}/{}/{}", robot_, name, component_);
  if (!changed(topic, hash_name(list))) return;
  recorder_.write_json(topic, "ganglion.Path", time_s_, fmt::format("{{\"points\":[{}]}}", list));
}

}  // namespace ganglion
