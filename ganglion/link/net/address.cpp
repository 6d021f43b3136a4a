#include "ganglion/link/net/address.h"

#include <algorithm>
#include <charconv>

#include "ganglion/base/text.h"

namespace ganglion::link {
namespace {

constexpr std::string_view kTcp = "tcp://", kSerial = "serial://", kSerialOverTcp = "serial+tcp://", kBaud = "?baud=";

template <class Number>
bool read_number(std::string_view text, Number& number) noexcept {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

Result<Address> parse_tcp(std::string_view text) {
  Address address;
  const std::size_t colon = text.rfind(':');
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-._:[]%").find(c) != std::string_view::npos;
  });
  if (!plain || colon == std::string_view::npos || colon == 0 || !read_number(text.substr(colon + 1), address.port)) {
    return fail(ErrorCode::BadParameter,
                {"\"{}\" is no address: write tcp://HOST:PORT, as in tcp://127.0.0.1:7007, or "
                 "serial:///dev/ttyUSB0?baud=115200",
                 "\"{}\" no es una dirección: escriba tcp://EQUIPO:PUERTO, como tcp://127.0.0.1:7007, o "
                 "serial:///dev/ttyUSB0?baud=115200"},
                printable(text, 200));
  }
  std::string_view host = text.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  address.host = host;
  address.text = tcp_text(address.host, address.port);
  return address;
}

Result<Address> parse_serial(std::string_view text) {
  Address address;
  address.kind = Address::Kind::Serial;
  const std::size_t question = text.find('?');
  address.device = text.substr(0, question);
  const std::string_view option = question == std::string_view::npos ? "" : text.substr(question);
  const bool good =
      option.empty() || (option.starts_with(kBaud) && read_number(option.substr(kBaud.size()), address.baud));
  if (!good || !address.device.starts_with('/') || address.baud == 0) {
    return fail(ErrorCode::BadParameter,
                {"\"{}\" is no serial line: write serial:///dev/ttyUSB0?baud=115200",
                 "\"{}\" no es una línea serie: escriba serial:///dev/ttyUSB0?baud=115200"},
                printable(text, 200));
  }
  address.text = fmt::format("serial://{}?baud={}", address.device, address.baud);
  return address;
}

}  // namespace

std::string tcp_text(const std::string& host, std::uint16_t port) {
  return host.find(':') == std::string::npos ? fmt::format("tcp://{}:{}", host, port)
                                             : fmt::format("tcp://[{}]:{}", host, port);
}

Result<Address> parse_address(const std::string& text) {
  if (text.starts_with(kSerialOverTcp)) {
    auto address = parse_tcp(std::string_view(text).substr(kSerialOverTcp.size()));
    if (!address) return address;
    address->kind = Address::Kind::SerialOverTcp;
    address->text = text;
    return address;
  }
  if (text.starts_with(kSerial)) return parse_serial(std::string_view(text).substr(kSerial.size()));
  return parse_tcp(text.starts_with(kTcp) ? std::string_view(text).substr(kTcp.size()) : std::string_view(text));
}

}  // namespace ganglion::link
