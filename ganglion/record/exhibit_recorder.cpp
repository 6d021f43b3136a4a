#include "ganglion/record/exhibit_recorder.h"

#include <fmt/format.h>

#include <cmath>

#include "ganglion/base/base64.h"
#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/record/exhibit/keep.h"

namespace ganglion {
namespace {

/// One field of one byte for each layer; what is unknown is 0 there, for those viewers know no better.
std::string grid_json(const shown::Field& field, double time_s) {
  const std::size_t layers = field.layers.size(), cells = field.cells.front().size();
  std::string names;
  std::vector<std::uint8_t> bytes(cells * layers);
  for (std::size_t layer = 0; layer < layers; ++layer) {
    names += fmt::format("{}{{\"name\":\"{}\",\"offset\":{},\"type\":1}}", layer > 0 ? "," : "",
                         field.layers[layer].name, layer);
    for (std::size_t i = 0; i < cells; ++i) {
      const std::uint8_t cell = field.cells[layer][i];
      bytes[i * layers + layer] =
          cell == shown::kUnknownCell ? std::uint8_t{0} : static_cast<std::uint8_t>(std::lround(cell * 255 / 254.0));
    }
  }
  return fmt::format(
      "{{\"timestamp\":{{\"sec\":{},\"nsec\":{}}},\"frame_id\":\"world\","
      "\"pose\":{{\"position\":{{\"x\":{},\"y\":{},\"z\":0}},\"orientation\":{{\"x\":0,\"y\":0,\"z\":0,\"w\":1}}}},"
      "\"column_count\":{},\"cell_size\":{{\"x\":{},\"y\":{}}},\"row_stride\":{},\"cell_stride\":{},"
      "\"fields\":[{}],\"data\":\"{}\"}}",
      static_cast<long>(time_s), static_cast<long>((time_s - std::floor(time_s)) * 1e9), field.origin.x, field.origin.y,
      field.columns, field.cell.x, field.cell.y, static_cast<std::size_t>(field.columns) * layers, layers, names,
      base64(bytes));
}

}  // namespace

/// One look at one exhibitor.
class ExhibitRecorder::Look final : public Exhibition {
 public:
  Look(ExhibitRecorder& recorder, const ExhibitOwner& owner, double time_s)
      : recorder_(recorder), owner_(owner), time_s_(time_s) {}

  bool lacks(std::string_view field, std::uint64_t generation) override {
    const auto found = recorder_.known_.find(exhibit_topic(owner_, "field", field));
    return found == recorder_.known_.end() || found->second.generation != generation;
  }
  void frame(const FrameExhibit& frame) override { write(frame.name, shown::keep(frame)); }
  void field(const FieldExhibit& field) override;
  void curve(const CurveExhibit& curve) override { write(curve.name, shown::keep(curve)); }
  void bars(const BarExhibit& bars) override { write(bars.name, shown::keep(bars)); }
  void marks(const MarkExhibit& marks) override { write(marks.name, shown::keep(marks)); }
  void network(const NetworkExhibit& network) override { write(network.name, shown::keep(network)); }

 private:
  void write(std::string_view name, const std::optional<shown::Exhibit>& exhibit);

  ExhibitRecorder& recorder_;
  const ExhibitOwner& owner_;
  double time_s_;
};

void ExhibitRecorder::Look::write(std::string_view name, const std::optional<shown::Exhibit>& exhibit) {
  if (!exhibit) return;
  const std::string topic = exhibit_topic(owner_, form_name(*exhibit), name);
  std::string bytes = encode(*exhibit);
  Known& known = recorder_.known_[topic];
  if (known.bytes == bytes) return;
  recorder_.sink_.write_exhibit(topic, time_s_, bytes);
  known.bytes = std::move(bytes);
}

void ExhibitRecorder::Look::field(const FieldExhibit& field) {
  auto exhibit = shown::keep(field);
  if (!exhibit) return;
  const std::string topic = exhibit_topic(owner_, "field", field.name);
  Known& known = recorder_.known_[topic];
  known.generation = field.generation;
  shown::Field& now = std::get<shown::Field>(exhibit->form);
  const bool grows = !known.field.cells.empty() && now.same_make(known.field);
  auto patch = grows ? difference(known.field, now) : std::nullopt;
  if (grows && !patch) return;
  if (grows && recorder_.sink_.archives()) {
    recorder_.sink_.write_exhibit(topic, time_s_, encode({{}, std::move(*patch)}));
  } else {
    recorder_.sink_.write_exhibit(topic, time_s_, encode(*exhibit));
  }
  known.field = std::move(now);
  if (recorder_.sink_.archives() && field.frame == "world" && !known.field.layers.empty()) {
    const std::string map = fmt::format("/robot{}/map/{}/{}", std::max(0, owner_.robot), owner_.name, field.name);
    recorder_.sink_.write_json(map, "foxglove.Grid", time_s_, grid_json(known.field, time_s_));
  }
}

void ExhibitRecorder::show(const Exhibitor& exhibitor, const ExhibitOwner& owner, double time_s) {
  Look look(*this, owner, time_s);
  exhibitor.show(look);
}

}  // namespace ganglion
