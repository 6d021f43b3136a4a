#include "ganglion/studio/live/sample.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "ganglion/base/base64.h"
#include "ganglion/base/json_depth.h"

namespace ganglion::studio {
namespace {

using Message = nlohmann::json;

constexpr double kMostCells = 1e9;

static_assert(std::endian::native == std::endian::little, "samples are little-endian; swap bytes here");

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof bytes);
}

std::string begin(SampleKind kind, const SampleHead& head, std::size_t payload) {
  std::string out;
  out.reserve(16 + payload);
  put(out, static_cast<std::uint8_t>(kind));
  put(out, std::uint8_t{1});
  put(out, head.stream);
  put(out, head.seq);
  put(out, head.time_s);
  return out;
}

/// What is no object, or nests too deep, becomes null.
Message object_in(std::string_view text) {
  return json_nests_within(text, kDeepestJson) ? Message::parse(text, nullptr, false) : Message();
}

const Message& member(const Message& object, const char* key) {
  static const Message kNone;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() ? *found : kNone;
}

double number(const Message& object, const char* key) {
  const Message& found = member(object, key);
  return found.is_number() ? found.get<double>() : 0;
}

/// 0 for what is no number of cells.
std::uint32_t count(const Message& object, const char* key) {
  const double value = number(object, key);
  return value >= 1 && value <= kMostCells ? static_cast<std::uint32_t>(value) : 0;
}

}  // namespace

std::string_view name_of(SampleKind kind) noexcept {
  switch (kind) {
    case SampleKind::Row:
      return "row";
    case SampleKind::Grid:
      return "grid";
    case SampleKind::Path:
      return "path";
    case SampleKind::Movers:
      return "movers";
    case SampleKind::Bundle:
      break;
  }
  return "bundle";
}

bool GridState::take(std::string_view text, std::uint32_t seq) {
  const Message json = object_in(text);
  if (!json.is_object() || !json.contains("data") || !json["data"].is_string()) return false;
  const auto bytes = base64_bytes(json["data"].get_ref<const std::string&>());
  const std::uint32_t columns = count(json, "column_count");
  std::vector<std::string> layers;
  if (json.contains("fields") && json["fields"].is_array()) {
    for (const Message& field : json["fields"]) {
      const Message& name = member(field, "name");
      layers.push_back(name.is_string() ? name.get<std::string>() : std::string());
    }
  }
  if (!bytes || columns == 0 || layers.empty() || bytes->size() % (columns * layers.size()) != 0) return false;
  const Message& at = member(member(json, "pose"), "position");
  const Vector2 origin{number(at, "x"), number(at, "y")};
  const double cell_m = number(member(json, "cell_size"), "x");
  const auto rows = static_cast<std::uint32_t>(bytes->size() / columns / layers.size());
  const bool same = columns == columns_ && rows == rows_ && origin.x == origin_.x && origin.y == origin_.y &&
                    cell_m == cell_m_ && layers == layers_;
  const std::size_t depth = layers.size();
  if (!same) {
    changed_.assign(std::size_t{columns} * rows, seq);
    reshaped_ = seq;
  } else {
    for (std::size_t cell = 0; cell < changed_.size(); ++cell) {
      if (!std::equal(bytes->begin() + static_cast<std::ptrdiff_t>(cell * depth),
                      bytes->begin() + static_cast<std::ptrdiff_t>((cell + 1) * depth),
                      bytes_.begin() + static_cast<std::ptrdiff_t>(cell * depth))) {
        changed_[cell] = seq;
      }
    }
  }
  columns_ = columns, rows_ = rows, origin_ = origin, cell_m_ = cell_m;
  layers_ = std::move(layers);
  bytes_ = *bytes;
  seq_ = seq;
  return true;
}

std::string GridState::sample(const SampleHead& head, std::uint32_t base) const {
  const bool whole = base == 0 || base < reshaped_;
  const std::size_t depth = layers_.size();
  std::vector<std::uint32_t> cells;
  for (std::size_t cell = 0; cell < changed_.size(); ++cell) {
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(cell * depth);
    const bool empty = std::all_of(first, first + static_cast<std::ptrdiff_t>(depth), [](auto b) { return b == 0; });
    if (whole ? !empty : changed_[cell] > base) cells.push_back(static_cast<std::uint32_t>(cell));
  }
  std::string out = begin(SampleKind::Grid, head, 44 + cells.size() * (4 + depth));
  put(out, whole ? std::uint32_t{0} : base);
  put(out, columns_);
  put(out, rows_);
  put(out, origin_.x);
  put(out, origin_.y);
  put(out, cell_m_);
  put(out, static_cast<std::uint32_t>(depth));
  put(out, static_cast<std::uint32_t>(cells.size()));
  for (const std::uint32_t cell : cells) put(out, cell);
  for (const std::uint32_t cell : cells) {
    for (std::size_t layer = 0; layer < depth; ++layer) put(out, bytes_[cell * depth + layer]);
  }
  return out;
}

std::string row_sample(const SampleHead& head, std::uint32_t tick, std::span<const double> values) {
  std::string out = begin(SampleKind::Row, head, 8 + values.size_bytes());
  put(out, tick);
  put(out, static_cast<std::uint32_t>(values.size()));
  for (const double value : values) put(out, value);
  return out;
}

std::optional<std::string> path_sample(const SampleHead& head, std::string_view text) {
  const Message json = object_in(text);
  if (!json.is_object() || !json.contains("points") || !json["points"].is_array()) return std::nullopt;
  const Message& points = json["points"];
  std::string out = begin(SampleKind::Path, head, 4 + points.size() * 16);
  put(out, static_cast<std::uint32_t>(points.size()));
  for (const Message& point : points) {
    const bool good = point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number();
    if (!good) return std::nullopt;
    put(out, point[0].get<double>());
    put(out, point[1].get<double>());
  }
  return out;
}

std::string movers_sample(const SampleHead& head, std::string_view json) {
  return begin(SampleKind::Movers, head, json.size()).append(json);
}

std::string bundle_sample(std::span<const std::shared_ptr<const std::string>> samples) {
  constexpr std::size_t kAlign = 8;
  std::size_t payload = 0;
  for (const auto& sample : samples) payload += 2 * kAlign + sample->size();
  std::string out = begin(SampleKind::Bundle, {}, payload);
  for (const auto& sample : samples) {
    put(out, static_cast<std::uint64_t>(sample->size()));
    out.append(*sample).append((kAlign - sample->size() % kAlign) % kAlign, '\0');
  }
  return out;
}

}  // namespace ganglion::studio
