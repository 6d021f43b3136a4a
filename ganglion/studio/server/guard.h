#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/sentence.h"

namespace ganglion::studio {

/// Who may ask, and by what name this server is asked.
struct GuardConfig {
  std::vector<std::string> hosts;  ///< Allowed Host headers, with port: "127.0.0.1:8745".
  std::string token;               ///< 64 hex digits: in the printed URL, and for scripts.
  std::string session;             ///< The cookie's value; another 64 hex digits.
  std::string cookie;              ///< Its name, which holds the port.
};

/// What of a request decides whether it is answered. Absent headers are "".
struct RequestHead {
  std::string_view method;
  std::string_view target;  ///< Path and query.
  std::string_view host;
  std::string_view origin;
  std::string_view cookies;
  std::string_view authorization;
  std::string_view fetch_site;  ///< Sec-Fetch-Site
  bool upgrade = false;         ///< To a WebSocket.
  int hosts = 1;                ///< How many Host headers there are.
  int origins = 0;              ///< How many Origin headers there are.
};

struct Verdict {
  unsigned status = 200;
  Sentence why{};
  std::string location;  ///< Of a 303: where to, with the cookie set.
};

/// The order: Host, then who asks, then from which page. Who shows the token in a header and names no page is a script.
Verdict judge(const GuardConfig& config, const RequestHead& head);

/// Hosts under which a server on this port may be asked: the names of this machine for itself, and `more` as given,
/// with the port where they have none.
std::vector<std::string> allowed_hosts(std::uint16_t port, const std::vector<std::string>& more);

/// In a time that does not tell where two texts differ.
bool same_secret(std::string_view a, std::string_view b) noexcept;

/// 256 bits from the system, as hex digits.
std::string random_secret();

}  // namespace ganglion::studio
