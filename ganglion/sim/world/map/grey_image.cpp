#include "ganglion/sim/world/map/grey_image.h"

#include <optional>

namespace ganglion::sim {
namespace {

constexpr int kMaxSide = 1 << 26;

bool is_space(char c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Walks over the words of a PGM file; a comment runs from # to the end of its line.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  std::size_t at() const noexcept { return at_; }

  /// The next whole number up to `most`; none if there is something else.
  std::optional<int> number(int most) noexcept {
    skip();
    const std::size_t start = at_;
    int value = 0;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
      value = value * 10 + (bytes_[at_] - '0');
      if (value > most) return std::nullopt;
    }
    const bool ended = at_ == bytes_.size() || is_space(bytes_[at_]) || bytes_[at_] == '#';
    return at_ > start && ended ? std::optional<int>(value) : std::nullopt;
  }

  /// Steps over the single white space between header and pixels.
  bool separator() noexcept { return at_ < bytes_.size() && is_space(bytes_[at_++]); }

 private:
  void skip() noexcept {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
      } else {
        ++at_;
      }
    }
  }
  std::string_view bytes_;
  std::size_t at_ = 2;
};

tl::unexpected<Error> too_bright(const std::string& file, std::size_t pixel, int value, const GreyImage& image) {
  return fail_at({file}, ErrorCode::Corrupt,
                 {"pixel {} (row {} from the top, column {}) is {}, above the maximum {}",
                  "el píxel {} (fila {} desde arriba, columna {}) es {}, mayor que el máximo {}"},
                 pixel, pixel / image.columns, pixel % image.columns, value, image.max_value);
}

Result<GreyImage> read_plain(Reader reader, GreyImage image, std::size_t pixels, const std::string& file) {
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto value = reader.number(65535);
    if (!value) {
      return fail_at({file}, ErrorCode::Corrupt,
                     {"pixel {} of {} is missing or no number from 0 to 65535",
                      "el píxel {} de {} falta o no es un número de 0 a 65535"},
                     i, pixels);
    }
    if (*value > image.max_value) return too_bright(file, i, *value, image);
    image.values.push_back(static_cast<std::uint16_t>(*value));
  }
  return image;
}

Result<GreyImage> read_binary(std::string_view bytes, GreyImage image, std::size_t pixels, const std::string& file) {
  const std::size_t width = image.max_value > 255 ? 2 : 1;
  if (bytes.size() < pixels * width) {
    return fail_at({file}, ErrorCode::Corrupt,
                   {"is cut: {} x {} pixels need {} bytes, {} are there",
                    "está cortado: {} x {} píxeles necesitan {} bytes, hay {}"},
                   image.columns, image.rows, pixels * width, bytes.size());
  }
  image.values.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const int high = static_cast<unsigned char>(bytes[i * width]);
    const int value = width == 1 ? high : high * 256 + static_cast<unsigned char>(bytes[i * 2 + 1]);
    if (value > image.max_value) return too_bright(file, i, value, image);
    image.values[i] = static_cast<std::uint16_t>(value);
  }
  return image;
}

}  // namespace

Result<GreyImage> parse_pgm(std::string_view bytes, const std::string& file_name, std::size_t max_pixels) {
  const bool plain = bytes.starts_with("P2");
  if (!plain && !bytes.starts_with("P5")) {
    return fail_at(
        {file_name}, ErrorCode::Unsupported,
        {"is no PGM picture: it must start with P5 or P2", "no es una imagen PGM: debe empezar con P5 o P2"});
  }
  Reader reader(bytes);
  const auto columns = reader.number(kMaxSide), rows = columns ? reader.number(kMaxSide) : std::nullopt;
  const auto max_value = rows ? reader.number(65535) : std::nullopt;
  if (!max_value || *columns < 1 || *rows < 1 || *max_value < 1 || !reader.separator()) {
    return fail_at({file_name}, ErrorCode::Syntax,
                   {"the header must be P5 or P2, width, height and a maximum from 1 to 65535",
                    "el encabezado debe ser P5 o P2, ancho, alto y un máximo de 1 a 65535"});
  }
  const std::size_t pixels = static_cast<std::size_t>(*columns) * static_cast<std::size_t>(*rows);
  if (pixels > max_pixels) {
    return fail_at({file_name}, ErrorCode::TooLarge,
                   {"has {} x {} pixels; the limit is {} in all", "tiene {} x {} píxeles; el límite es {} en total"},
                   *columns, *rows, max_pixels);
  }
  GreyImage image{*columns, *rows, *max_value, {}};
  return plain ? read_plain(reader, std::move(image), pixels, file_name)
               : read_binary(bytes.substr(reader.at()), std::move(image), pixels, file_name);
}

}  // namespace ganglion::sim
