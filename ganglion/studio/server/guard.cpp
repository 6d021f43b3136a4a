#include "ganglion/studio/server/guard.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <sys/random.h>

#include "ganglion/base/expects.h"
#include "ganglion/base/text.h"
#include "ganglion/studio/api/query.h"

namespace ganglion::studio {
namespace {

bool has_cookie(std::string_view cookies, std::string_view name, std::string_view value) {
  bool found = false;
  for (const std::string& part : split(cookies, ';')) {
    const std::string_view one = trimmed(part);
    const std::size_t equals = one.find('=');
    if (equals == std::string_view::npos || one.substr(0, equals) != name) continue;
    found = same_secret(one.substr(equals + 1), value) || found;
  }
  return found;
}

/// The target without its token.
std::string without_token(std::string_view target) {
  const std::size_t question = target.find('?');
  std::string result(target.substr(0, question));
  char separator = '?';
  for (const std::string& part : split(target.substr(question + 1), '&')) {
    if (part.empty() || part.starts_with("token=")) continue;
    result += separator + part;
    separator = '&';
  }
  // "//elsewhere" would lead to another host, and so would "/\\elsewhere": to a browser they are the same.
  while (result.starts_with("//") || result.starts_with("/\\")) result.erase(1, 1);
  return result;
}

bool is_reading(std::string_view method) { return method == "GET" || method == "HEAD"; }

Verdict refused(unsigned status, Sentence why) { return {status, std::move(why), ""}; }

}  // namespace

Verdict judge(const GuardConfig& config, const RequestHead& head) {
  const bool known_host = std::find(config.hosts.begin(), config.hosts.end(), head.host) != config.hosts.end();
  if (!known_host || head.hosts != 1) {
    return refused(421, say({"this server does not answer to that Host", "este servidor no responde a ese Host"}));
  }
  if (head.method == "GET" && !head.upgrade && head.target.starts_with('/')) {
    if (const auto token = query_value(head.target, "token")) {
      if (same_secret(*token, config.token)) return {303, {}, without_token(head.target)};
      return refused(401, say({"the token in the URL is not this server's",
                               "la clave (token) de la URL no es la de este servidor"}));
    }
  }
  constexpr std::string_view kBearer = "Bearer ";
  const bool script =
      head.authorization.starts_with(kBearer) && same_secret(head.authorization.substr(kBearer.size()), config.token);
  if (!script && !has_cookie(head.cookies, config.cookie, config.session)) {
    return refused(401, say({"open the URL that ganglion studio printed; it holds the key",
                             "abra la URL que escribió ganglion studio; contiene la clave"}));
  }
  const bool own_page = head.origins == 1 && head.origin == "http://" + std::string(head.host);
  const bool no_page =
      script && head.origins == 0;  // a browser names the page of every such request, a script has none
  if ((!is_reading(head.method) || head.upgrade) && !own_page && !no_page) {
    return refused(403, say({"only this server's own page may ask for that: Origin must be http://{}",
                             "solo la página de este servidor puede pedir eso: Origin debe ser http://{}"},
                            head.host));
  }
  const bool own_fetch = head.fetch_site.empty() || head.fetch_site == "same-origin" || head.fetch_site == "none";
  if ((head.origins > 0 && !own_page) || !own_fetch) {
    return refused(403, say({"another page asked", "lo pidió otra página"}));
  }
  return {};
}

std::vector<std::string> allowed_hosts(std::uint16_t port, const std::vector<std::string>& more) {
  const std::string suffix = ":" + std::to_string(port);
  std::vector<std::string> hosts = {"127.0.0.1" + suffix, "localhost" + suffix, "[::1]" + suffix};
  for (const std::string& host : more) {
    const bool has_port = host.find(':', host.starts_with('[') ? host.find(']') : 0) != std::string::npos;
    hosts.push_back(has_port ? host : host + suffix);
  }
  return hosts;
}

bool same_secret(std::string_view a, std::string_view b) noexcept {
  unsigned different = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const char other = i < a.size() ? a[i] : '\0';
    different |= static_cast<unsigned char>(other) ^ static_cast<unsigned char>(b[i]);
  }
  return different == 0;
}

std::string random_secret() {
  std::array<unsigned char, 32> bytes{};
  expects(::getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
  std::string hex;
  for (const unsigned char byte : bytes) hex += fmt::format("{:02x}", byte);
  return hex;
}

}  // namespace ganglion::studio
