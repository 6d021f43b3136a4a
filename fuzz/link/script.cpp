#include "fuzz/link/script.h"

#include <algorithm>

namespace ganglion::fuzz {
namespace {

constexpr std::size_t kHeadBytes = 3;
constexpr std::size_t kMostPieceBytes = 0xFFFF;

}  // namespace

Script Script::parse(std::string_view input) {
  Script script;
  if (input.empty()) return script;
  const auto choices = static_cast<unsigned char>(input.front());
  script.to_controller = (choices & 1) != 0;
  script.free_running = (choices & 2) != 0;
  script.deaf = (choices & 4) != 0;
  input.remove_prefix(1);
  while (input.size() >= kHeadBytes) {
    const std::size_t length =
        static_cast<unsigned char>(input[1]) | static_cast<std::size_t>(static_cast<unsigned char>(input[2])) << 8;
    script.pieces.push_back({static_cast<std::uint8_t>(input[0]), std::string(input.substr(kHeadBytes, length))});
    input.remove_prefix(std::min(input.size(), kHeadBytes + length));
  }
  return script;
}

std::string Script::text() const {
  std::string text(1, static_cast<char>((to_controller ? 1 : 0) | (free_running ? 2 : 0) | (deaf ? 4 : 0)));
  for (const Piece& piece : pieces) {
    const std::size_t length = std::min(piece.bytes.size(), kMostPieceBytes);
    text += static_cast<char>(piece.wait);
    text += static_cast<char>(length & 0xFF);
    text += static_cast<char>(length >> 8);
    text.append(piece.bytes, 0, length);
  }
  return text;
}

}  // namespace ganglion::fuzz
