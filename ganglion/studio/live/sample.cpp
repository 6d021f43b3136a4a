#include "ganglion/studio/live/sample.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "ganglion/record/exhibit/exhibit_json.h"

namespace ganglion::studio {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are little-endian; swap bytes here");

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof bytes);
}

std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
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

}  // namespace

std::string_view name_of(SampleKind kind) noexcept {
  switch (kind) {
    case SampleKind::Row:
      return "row";
    case SampleKind::Field:
      return "field";
    case SampleKind::Exhibit:
      return "exhibit";
    case SampleKind::Movers:
      return "movers";
    case SampleKind::Bundle:
      break;
  }
  return "bundle";
}

bool FieldState::take(const shown::Exhibit& state, std::uint32_t seq) {
  if (const auto* whole = std::get_if<shown::Field>(&state.form)) {
    title_ = state.title;
    take_whole(*whole, seq);
    return true;
  }
  const auto* patch = std::get_if<shown::Patch>(&state.form);
  if (patch == nullptr || !shown::apply(*patch, field_)) return false;
  for (int row = patch->row; row < patch->row + patch->rows; ++row) {
    const auto from = changed_.begin() + std::ptrdiff_t{row} * field_.columns + patch->column;
    std::fill(from, from + patch->columns, seq);
  }
  seq_ = seq;
  return true;
}

void FieldState::take_whole(const shown::Field& field, std::uint32_t seq) {
  if (field.same_make(field_)) {
    for (std::size_t layer = 0; layer < field.cells.size(); ++layer) {
      for (std::size_t cell = 0; cell < changed_.size(); ++cell) {
        if (field.cells[layer][cell] != field_.cells[layer][cell]) changed_[cell] = seq;
      }
    }
  } else {
    changed_.assign(static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows), seq);
    remade_ = seq;
  }
  field_ = field;
  seq_ = seq;
}

std::string FieldState::sample(const SampleHead& head, std::uint32_t base) const {
  const bool whole = base == 0 || base < remade_;
  const std::size_t depth = field_.cells.size();
  const auto known = [&](std::size_t cell) {
    return std::any_of(field_.cells.begin(), field_.cells.end(),
                       [cell](const auto& layer) { return layer[cell] != shown::kUnknownCell; });
  };
  std::vector<std::uint32_t> cells;
  for (std::size_t cell = 0; cell < changed_.size(); ++cell) {
    if (whole ? known(cell) : changed_[cell] > base) cells.push_back(static_cast<std::uint32_t>(cell));
  }
  const std::string words = whole ? dumped(json_of(shown::Exhibit{title_, field_})) : std::string();
  std::string out = begin(SampleKind::Field, head, 40 + cells.size() * (4 + depth) + words.size());
  put(out, whole ? std::uint32_t{0} : base);
  put(out, static_cast<std::uint32_t>(field_.columns));
  put(out, static_cast<std::uint32_t>(field_.rows));
  put(out, field_.origin.x);
  put(out, field_.origin.y);
  put(out, static_cast<std::uint32_t>(depth));
  put(out, static_cast<std::uint32_t>(cells.size()));
  put(out, static_cast<std::uint32_t>(words.size()));
  for (const std::uint32_t cell : cells) put(out, cell);
  for (const std::uint32_t cell : cells) {
    for (std::size_t layer = 0; layer < depth; ++layer) put(out, field_.cells[layer][cell]);
  }
  return out.append(words);
}

std::string row_sample(const SampleHead& head, std::uint32_t tick, std::span<const double> values) {
  std::string out = begin(SampleKind::Row, head, 8 + values.size_bytes());
  put(out, tick);
  put(out, static_cast<std::uint32_t>(values.size()));
  for (const double value : values) put(out, value);
  return out;
}

std::string movers_sample(const SampleHead& head, std::string_view json) {
  return begin(SampleKind::Movers, head, json.size()).append(json);
}

std::string exhibit_sample(const SampleHead& head, const shown::Exhibit& exhibit) {
  const std::string json = dumped(json_of(exhibit));
  return begin(SampleKind::Exhibit, head, json.size()).append(json);
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
