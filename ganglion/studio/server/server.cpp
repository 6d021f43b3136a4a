#include "ganglion/studio/server/server.h"

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>

#include "ganglion/base/denied.h"
#include "ganglion/studio/server/core.h"

namespace ganglion::studio {
namespace {

constexpr auto kDrainEvery = std::chrono::milliseconds(10);
constexpr auto kLookEvery = std::chrono::milliseconds(1000);

}  // namespace

std::uint64_t Connections::add(std::function<void()> drop) {
  make_room();
  open_[next_] = {std::move(drop)};
  return next_++;
}

void Connections::make_room() {
  if (open_.size() < kMost) return;
  auto goes = std::find_if(open_.begin(), open_.end(), [](const auto& one) { return !one.second.admitted; });
  if (goes == open_.end()) {
    goes = std::find_if(open_.begin(), open_.end(), [](const auto& one) { return !one.second.watching; });
  }
  if (goes == open_.end()) return;
  const auto drop = std::move(goes->second.drop);
  open_.erase(goes);
  drop();
}

void Connections::admit(std::uint64_t id) {
  if (const auto found = open_.find(id); found != open_.end()) found->second.admitted = true;
}

bool Connections::watch(std::uint64_t id) {
  const auto watching = std::count_if(open_.begin(), open_.end(), [](const auto& one) { return one.second.watching; });
  const auto found = open_.find(id);
  if (found == open_.end() || static_cast<std::size_t>(watching) >= kMostViewers) return false;
  found->second.watching = true;
  return true;
}

struct Server::Core {
  explicit Core(const ServerOptions& options) : shared(Assets(options.web_root), random_secret().substr(0, 16)) {}

  Result<void> listen(const ServerOptions& options);
  void accept();
  void drain();
  void look();
  /// Serves until it is stopped, whatever is denied on the way.
  void serve() noexcept;

  ServerCore shared;
  tcp::acceptor acceptor{shared.io};
  asio::steady_timer retry{shared.io}, drain_timer{shared.io}, look_timer{shared.io};
  std::uint16_t port = 0;
  std::string host;
  bool accepting = false, draining = false, looking = false;  // else nothing waits for it to go on
  std::thread thread;
};

Result<void> Server::Core::listen(const ServerOptions& options) {
  boost::system::error_code error;
  const auto address = asio::ip::make_address(options.address, error);
  if (error) {
    return fail(ErrorCode::BadParameter,
                {"\"{}\" is no address to listen on; write 127.0.0.1:PORT",
                 "\"{}\" no es una dirección en la que escuchar; escriba 127.0.0.1:PUERTO"},
                options.address);
  }
  if (!address.is_loopback() && options.allow_hosts.empty()) {
    return fail(ErrorCode::BadParameter,
                {"{} can be reached by other machines: say by which name with --allow-host, if you mean it",
                 "a {} llegan otras máquinas: diga con qué nombre mediante --allow-host, si es lo que quiere"},
                options.address);
  }
  const tcp::endpoint endpoint(address, options.port);
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error) {
    return fail(ErrorCode::Unwritable, {"cannot listen on {}:{}: {}", "no se puede escuchar en {}:{}: {}"},
                options.address, options.port, error.message());
  }
  port = acceptor.local_endpoint().port();
  host = address.is_v6() ? "[" + address.to_string() + "]" : address.to_string();
  if (address.is_unspecified()) host = "127.0.0.1";
  return {};
}

void Server::Core::serve() noexcept {
  while (!shared.io.stopped()) {
    unless_denied([this] {
      if (!accepting) accept();
      if (!draining) drain();
      if (!looking) look();
      shared.io.run();
    });
  }
}

void Server::Core::accept() {
  accepting = false;
  acceptor.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    accepting = false;
    if (error) {  // out of descriptors, say: that passes
      retry.expires_after(std::chrono::milliseconds(50));
      retry.async_wait([this](const boost::system::error_code& stopped) {
        if (!stopped) accept();
      });
      accepting = true;
      return;
    }
    accept();
    serve_connection(shared, std::move(socket));
  });
  accepting = true;
}

void Server::Core::drain() {
  drain_timer.expires_after(kDrainEvery);
  drain_timer.async_wait([this](const boost::system::error_code& stopped) {
    draining = false;
    if (stopped) return;
    unless_denied([this] { shared.hub.drain(); });
    drain();
  });
  draining = true;
}

void Server::Core::look() {
  look_timer.expires_after(kLookEvery);
  look_timer.async_wait([this](const boost::system::error_code& stopped) {
    looking = false;
    if (stopped) return;
    asio::post(shared.worker, [this] { unless_denied([this] { shared.api->look_for_changes(); }); });
    look();
  });
  looking = true;
}

Server::Server(std::unique_ptr<Core> core) : core_(std::move(core)) {
  core_->thread = std::thread([core = core_.get()] { core->serve(); });
}

Result<std::unique_ptr<Server>> Server::start(const ServerOptions& options) try {
  auto folder = Folder::open(options.folder);
  if (!folder) return tl::unexpected<Error>(folder.error());
  Problems problems;
  auto programs = read_programs(options.programs, problems);
  if (!problems.empty()) return tl::unexpected<Error>(problems.sorted().front());
  auto core = std::make_unique<Core>(options);
  if (auto listening = core->listen(options); !listening) return tl::unexpected<Error>(listening.error());
  ServerCore& shared = core->shared;
  shared.guard = {allowed_hosts(core->port, options.allow_hosts), random_secret(), random_secret(),
                  fmt::format("ganglion_{}", core->port)};
  Api::Hooks hooks;
  hooks.on_hub = [&shared](std::function<void(Hub&)> what) {
    asio::post(shared.io, [&shared, what = std::move(what)] { unless_denied([&] { what(shared.hub); }); });
  };
  hooks.later = [&shared](std::function<void()> what) {
    asio::post(shared.worker, [what = std::move(what)] { unless_denied(what); });
  };
  shared.api = std::make_unique<Api>(std::move(*folder), std::move(programs), hooks);
  return std::unique_ptr<Server>(new Server(std::move(core)));
} catch (const std::exception&) {  // no thread, no memory
  return tl::unexpected(denied());
}

Server::~Server() {
  core_->shared.io.stop();
  core_->thread.join();
  core_->shared.worker.stop();
  core_->shared.worker.join();
  core_->shared.api.reset();  // ends the run, which may still call the worker
}

std::uint16_t Server::port() const noexcept { return core_->port; }
const std::string& Server::token() const noexcept { return core_->shared.guard.token; }
std::string Server::url() const { return fmt::format("http://{}:{}/?token={}", core_->host, core_->port, token()); }

void Server::attach(std::shared_ptr<LiveFeed> feed, Json state) {
  asio::post(core_->shared.io,
             [core = core_.get(), feed = std::move(feed)] { unless_denied([&] { core->shared.hub.watch(feed); }); });
  tell_attached(std::move(state));
}

void Server::tell_attached(Json state) {
  state["attached"] = true;
  asio::post(core_->shared.worker,
             [core = core_.get(), state] { unless_denied([&] { core->shared.api->attach(state); }); });
  asio::post(core_->shared.io,
             [core = core_.get(), state] { unless_denied([&] { core->shared.hub.set_state(state); }); });
}

}  // namespace ganglion::studio
