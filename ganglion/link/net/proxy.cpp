#include "ganglion/link/net/proxy.h"

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <deque>
#include <set>

#include "ganglion/link/fault/faulty_connection.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/listen.h"

namespace ganglion::link {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using ErrorText = boost::system::error_code;

constexpr std::chrono::milliseconds kRound(50);
constexpr std::size_t kMostPendingBytes = std::size_t{4} << 20;  // under way; then who sends has to wait
constexpr std::size_t kMostConnections = 256;
constexpr double kLongestWait_s = 3600;

Way back(Way way) noexcept { return way == Way::ToRobot ? Way::ToController : Way::ToRobot; }

}  // namespace

/// Sockets and timers around connections with faults.
class Proxy::Shell {
 public:
  explicit Shell(ProxyConfig config) : config_(std::move(config)), acceptor_(context_) {}

  Result<void> open();
  const Address& address() const noexcept { return config_.listen; }
  void serve(const std::function<bool()>& stop) {
    while (!stop()) {
      context_.restart();
      context_.run_for(kRound);
    }
    ErrorText ignored;
    acceptor_.close(ignored);
    for (const auto& pair : std::set(pairs_)) drop(pair);
    context_.restart();
    context_.poll();
  }

 private:
  struct Pair;
  using Shared = std::shared_ptr<Pair>;
  void accept();
  void welcome(tcp::socket socket);
  void drop(const Shared& pair);
  void log(const Sentence& line) const {
    if (config_.log) config_.log(line);
  }
  double now_s() noexcept { return steady_s() - begun_s_; }

  ProxyConfig config_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  tcp::resolver::results_type robot_;
  std::set<Shared> pairs_;
  std::uint32_t next_number_ = 0;
  double begun_s_ = 0;  // of the first connection, on the steady clock
};

/// A controller's connection and the one to the robot that goes with it.
struct Proxy::Shell::Pair : std::enable_shared_from_this<Pair> {
  struct Side {
    explicit Side(tcp::socket with) : socket(std::move(with)) {}
    tcp::socket socket;
    std::deque<FaultyConnection::Arrival> arrived;  // to be written, piece by piece
    bool reading = false, writing = false;
    bool said_all = false;  // it closed
    bool told_all = false;  // it was told that nothing follows
    std::array<char, 16384> room;
  };
  Pair(Shell& of, tcp::socket controller, std::uint32_t its_number)
      : shell(of),
        number(its_number),
        way(of.config_.faults, of.config_.seed, its_number, Carrier::Stream),
        timer(of.context_),
        sides{Side(tcp::socket(of.context_)), Side(std::move(controller))} {}

  /// The side that gets what goes that way.
  Side& at(Way to) noexcept { return sides[static_cast<std::size_t>(to)]; }

  void begin() {
    asio::async_connect(
        at(Way::ToRobot).socket, shell.robot_,
        [self = shared_from_this()](const ErrorText& error, const tcp::endpoint&) {
          if (error) {
            self->shell.log(say({"connection {}: no robot at {}: {}", "conexión {}: no hay robot en {}: {}"},
                                self->number, self->shell.config_.to.text, error.message()));
            return self->shell.drop(self);
          }
          ErrorText ignored;
          self->at(Way::ToRobot).socket.set_option(tcp::no_delay(true), ignored);
          self->look();
        });
  }

  /// Reads from the side that sends that way, unless too much of it is under way.
  void read(Way to) {
    Side& from = at(back(to));
    std::size_t waiting = way.pending(to);
    for (const auto& one : at(to).arrived) waiting += one.bytes.size();
    if (from.reading || from.said_all || !from.socket.is_open() || waiting > kMostPendingBytes) return;
    from.reading = true;
    from.socket.async_read_some(asio::buffer(from.room),
                                [self = shared_from_this(), to](const ErrorText& error, std::size_t got) {
                                  Side& side = self->at(back(to));
                                  side.reading = false;
                                  const double now_s = self->shell.now_s();
                                  if (error) {
                                    side.said_all = true;
                                    self->way.finish(to, now_s);
                                  } else {
                                    self->way.push(to, {side.room.data(), got}, now_s);
                                  }
                                  self->look();
                                });
  }

  /// Writes the next piece that has arrived, each by itself.
  void write(Way to) {
    Side& side = at(to);
    if (side.writing || side.arrived.empty() || !side.socket.is_open()) return;
    if (side.arrived.front().bytes.empty()) return end(to);
    side.writing = true;
    asio::async_write(side.socket, asio::buffer(side.arrived.front().bytes),
                      [self = shared_from_this(), to](const ErrorText& error, std::size_t) {
                        Side& written = self->at(to);
                        written.writing = false;
                        if (error || written.arrived.front().end) return self->end(to);
                        written.arrived.pop_front();
                        self->look();
                      });
  }

  void end(Way to) {
    Side& side = at(to);
    ErrorText ignored;
    side.socket.shutdown(tcp::socket::shutdown_send, ignored);
    side.arrived.clear();
    side.told_all = true;
    look();
  }

  /// Carries on with whatever can be done now.
  void look() {
    if (!at(Way::ToRobot).socket.is_open() || !at(Way::ToController).socket.is_open()) return;
    const double now_s = shell.now_s();
    for (const Way to : {Way::ToRobot, Way::ToController}) {
      while (auto arrival = way.take(to, now_s)) {
        if (!at(to).told_all) at(to).arrived.push_back(std::move(*arrival));
      }
      write(to);
      read(to);
    }
    if (way.reset()) return reset();
    if (at(Way::ToRobot).told_all && at(Way::ToController).told_all) return shell.drop(shared_from_this());
    await();
  }

  void await() {
    const double wait_s = std::clamp(way.due_s() - shell.now_s(), 0.0, kLongestWait_s);
    timer.expires_after(std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(wait_s)));
    timer.async_wait([self = shared_from_this()](const ErrorText& error) {
      if (!error) self->look();
    });
  }

  void reset() {
    for (Side& side : sides) {
      ErrorText ignored;
      side.socket.set_option(asio::socket_base::linger(true, 0), ignored);  // closing sends RST
    }
    shell.drop(shared_from_this());
  }

  Shell& shell;
  std::uint32_t number;
  FaultyConnection way;
  asio::steady_timer timer;
  std::array<Side, 2> sides;  // robot, controller: by the Way that leads to it
};

Result<void> Proxy::Shell::open() {
  for (const Address* one : {&config_.listen, &config_.to}) {
    if (one->kind == Address::Kind::Tcp) continue;
    return fail(ErrorCode::BadParameter,
                {"{}: the proxy goes between TCP addresses; write tcp://HOST:PORT",
                 "{}: el proxy va entre direcciones TCP; escriba tcp://EQUIPO:PUERTO"},
                one->text);
  }
  ErrorText error;
  tcp::resolver resolver(context_);
  robot_ = resolver.resolve(config_.to.host, std::to_string(config_.to.port), error);
  if (error) {
    return fail(ErrorCode::LinkLost, {"{}: no such host: {}", "{}: no existe ese equipo: {}"}, config_.to.text,
                error.message());
  }
  if (auto listens = listen_at(acceptor_, config_.listen); !listens) return listens;
  accept();
  return {};
}

void Proxy::Shell::accept() {
  acceptor_.async_accept([this](const ErrorText& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error && pairs_.size() < kMostConnections) welcome(std::move(socket));  // else it is closed at once
    accept();
  });
}

void Proxy::Shell::welcome(tcp::socket socket) {
  ErrorText error;
  const tcp::endpoint from = socket.remote_endpoint(error);
  if (!error) socket.set_option(tcp::no_delay(true), error);
  if (error) return;  // gone already
  if (next_number_ == 0) begun_s_ = steady_s();
  const auto pair = std::make_shared<Pair>(*this, std::move(socket), next_number_++);
  pairs_.insert(pair);
  log(say({"{:.3f} s: connection {} from {}:{}", "{:.3f} s: conexión {} desde {}:{}"}, now_s(), pair->number,
          from.address().to_string(), from.port()));
  pair->begin();
}

void Proxy::Shell::drop(const Shared& pair) {
  if (pairs_.erase(pair) == 0) return;
  log(say({"{:.3f} s: connection {} {}: to the robot {}; to the controller {}",
           "{:.3f} s: la conexión {} {}: hacia el robot {}; hacia el controlador {}"},
          now_s(), pair->number, pair->way.reset() ? Text{"cut off", "se cortó"} : Text{"ended", "terminó"},
          pair->way.counts(Way::ToRobot).text(), pair->way.counts(Way::ToController).text()));
  pair->timer.cancel();
  for (Pair::Side& side : pair->sides) {
    ErrorText ignored;
    side.socket.close(ignored);
  }
}

Proxy::Proxy(std::unique_ptr<Shell> shell) : shell_(std::move(shell)) {}
Proxy::~Proxy() = default;

Result<std::unique_ptr<Proxy>> Proxy::listen(ProxyConfig config) {
  auto shell = std::make_unique<Shell>(std::move(config));
  if (auto opened = shell->open(); !opened) return tl::unexpected<Error>(opened.error());
  return std::unique_ptr<Proxy>(new Proxy(std::move(shell)));
}

const Address& Proxy::address() const noexcept { return shell_->address(); }

void Proxy::serve(const std::function<bool()>& stop) { shell_->serve(stop); }

}  // namespace ganglion::link
