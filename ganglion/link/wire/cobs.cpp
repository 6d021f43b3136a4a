#include "ganglion/link/wire/cobs.h"

#include <array>

namespace ganglion::link {
namespace {

constexpr std::array<std::uint16_t, 256> make_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned crc = byte << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ ((crc & 0x8000u) != 0 ? 0x1021u : 0u);
    table[byte] = static_cast<std::uint16_t>(crc);
  }
  return table;
}
constexpr auto kTable = make_table();

/// Puts bytes into blocks of at most 254, each behind its length + 1; a shorter block stands for a zero at its end.
class Stuffer {
 public:
  explicit Stuffer(std::string& out) : out_(out) { open(); }
  void put(char byte) {
    if (out_.size() - code_ == 0xFF) open();
    if (byte == 0) {
      open();
      return;
    }
    out_.push_back(byte);
    ++out_[code_];
  }

 private:
  void open() {
    code_ = out_.size();
    out_.push_back(1);
  }
  std::string& out_;
  std::size_t code_ = 0;
};

}  // namespace

std::uint16_t crc16(std::string_view bytes) noexcept {
  std::uint16_t crc = 0xFFFF;
  for (const char byte : bytes) {
    crc = static_cast<std::uint16_t>((crc << 8) ^ kTable[(crc >> 8) ^ static_cast<unsigned char>(byte)]);
  }
  return crc;
}

void append_packet(std::string_view payload, std::string& out) {
  const std::uint16_t crc = crc16(payload);
  Stuffer stuffer(out);
  for (const char byte : payload) stuffer.put(byte);
  stuffer.put(static_cast<char>(crc >> 8));
  stuffer.put(static_cast<char>(crc & 0xFF));
  out.push_back(0);
}

bool open_packet(std::string& packet, std::string_view& payload) noexcept {
  std::size_t to = 0;
  for (std::size_t from = 0; from < packet.size();) {
    const auto code = static_cast<unsigned char>(packet[from]);
    if (code == 0 || from + code > packet.size()) return false;
    for (std::size_t n = 1; n < code; ++n) packet[to++] = packet[from + n];
    from += code;
    if (code < 0xFF && from < packet.size()) packet[to++] = 0;
  }
  if (to < 2) return false;
  payload = std::string_view(packet.data(), to - 2);
  const auto high = static_cast<unsigned char>(packet[to - 2]), low = static_cast<unsigned char>(packet[to - 1]);
  return crc16(payload) == (high << 8 | low);
}

}  // namespace ganglion::link
