#include "ganglion/link/net/server.h"

#include <unistd.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/steady_timer.hpp>
#include <map>
#include <random>

#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/listen.h"

namespace ganglion::link {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using ErrorText = boost::system::error_code;

constexpr double kRound_s = 0.05;                     // at most between two looks at the clock
constexpr double kLinger_s = 1;                       // for a last word to be read
constexpr double kReopen_s = 0.5;                     // a serial line that went away
constexpr std::chrono::milliseconds kAcceptPause{1};  // a storm of strangers must not hold up who commands
constexpr std::size_t kSmallRead_bytes = 256;         // at a time from those who do not command,
constexpr std::chrono::milliseconds kRest{10};        // and then not again for so long
constexpr double kNoFiles_s = 0.1;                    // accepting again when the system has no descriptors left

}  // namespace

/// Sockets and timers around the robot's end.
class Server::Shell {
 public:
  Shell(RobotEnd& end, Address address)
      : end_(end), address_(std::move(address)), acceptor_(context_), timer_(context_), accept_timer_(context_) {}

  Result<void> open() {
    if (address_.kind == Address::Kind::SerialOverTcp) {
      return fail(ErrorCode::BadParameter,
                  {"{}: listening is done at tcp://HOST:PORT or a serial line",
                   "{}: se escucha en tcp://EQUIPO:PUERTO o en una línea serie"},
                  address_.text);
    }
    return address_.kind == Address::Kind::Tcp ? open_tcp() : open_serial();
  }
  const Address& address() const noexcept { return address_; }

  void serve(const std::function<bool()>& stop, const Sentence& reason) {
    tick();
    while (!stop()) {
      context_.restart();
      context_.run_for(std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(kRound_s)));
    }
    end_.shut_down(reason, steady_s());
    look();
    ErrorText ignored;
    acceptor_.close(ignored);
    timer_.cancel();
    accept_timer_.cancel();
    context_.restart();
    context_.poll();
  }

 private:
  using PeerId = RobotEnd::PeerId;

  /// A socket, or a serial port.
  template <class Stream>
  struct Connection : std::enable_shared_from_this<Connection<Stream>> {
    Connection(Shell& of, Stream with) : shell(of), stream(std::move(with)), rest(of.context_) {}

    void read() {
      if (shell.end_.waits(id)) return shell.wait_for_work(*this);
      const std::size_t most = shell.end_.commands(id) ? room.size() : kSmallRead_bytes;
      stream.async_read_some(asio::buffer(room.data(), most),
                             [self = this->shared_from_this()](const ErrorText& error, std::size_t got) {
                               if (error) return self->shell.drop(*self);
                               if (!self->lingering)
                                 self->shell.end_.receive(self->id, {self->room.data(), got}, steady_s());
                               self->go_on();
                               self->shell.look();
                             });
    }
    /// Reads again: at once who commands, all others when they have rested.
    void go_on() {
      if (shell.end_.commands(id)) return read();
      rest.expires_after(kRest);
      rest.async_wait([self = this->shared_from_this()](const ErrorText& error) {
        if (!error) self->read();
      });
    }
    /// Sends what is outgoing as far as it goes at once; the rest when there is room again.
    void write() {
      if (writing || lingering) return;
      for (;;) {
        const std::string_view bytes = shell.end_.outgoing(id);
        if (bytes.empty()) break;
        ErrorText error;
        const std::size_t sent = stream.write_some(asio::buffer(bytes.data(), bytes.size()), error);
        if (error == asio::error::would_block) return wait_for_room();
        if (error) return shell.drop(*this);
        shell.end_.sent(id, sent, steady_s());
      }
      if (shell.end_.closing(id)) shell.linger(*this);
    }
    void wait_for_room() {
      writing = true;
      stream.async_wait(Stream::wait_write, [self = this->shared_from_this()](const ErrorText& error) {
        self->writing = false;
        if (!error) self->write();
      });
    }

    Shell& shell;
    Stream stream;
    asio::steady_timer rest;
    PeerId id = 0;
    bool writing = false;
    bool lingering = false;
    double lingers_until_s = 0;
    std::array<char, 16384> room;
  };
  using Socket = Connection<tcp::socket>;
  using Serial = Connection<asio::posix::stream_descriptor>;

  Result<void> open_tcp() {
    if (auto listens = listen_at(acceptor_, address_); !listens) return listens;
    accept();
    return {};
  }

  void accept() {
    acceptor_.async_accept([this](const ErrorText& error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) {  // no descriptors left: the connections there are go on
        accept_again_s_ = steady_s() + kNoFiles_s;
        return;
      }
      welcome(std::move(socket));
      accept_timer_.expires_after(kAcceptPause);
      accept_timer_.async_wait([this](const ErrorText& cancelled) {
        if (!cancelled) accept();
      });
    });
  }

  void welcome(tcp::socket socket) {
    ErrorText error;
    const tcp::endpoint from = socket.remote_endpoint(error);
    if (!error) socket.set_option(tcp::no_delay(true), error);
    if (!error) socket.non_blocking(true, error);
    if (error) return;  // gone already
    auto made = std::make_shared<Socket>(*this, std::move(socket));
    made->id = end_.open(Carrier::Stream, fmt::format("{}:{}", from.address().to_string(), from.port()), steady_s());
    sockets_.emplace(made->id, made);
    made->read();
    look();
  }

  Result<void> open_serial() {
    ErrorText error;
    asio::serial_port port(context_);
    asio::posix::stream_descriptor raw(context_);  // unlike the port, it can be written without waiting
    port.open(address_.device, error);
    if (!error) port.set_option(asio::serial_port::baud_rate(address_.baud), error);
    if (!error) raw.assign(::dup(port.native_handle()), error);
    if (!error) raw.non_blocking(true, error);
    if (error) {
      return fail(ErrorCode::LinkLost,
                  {"{}: {}. Is it plugged in, and may you use it (group dialout)?",
                   "{}: {}. ¿Está enchufado, y puede usted usarlo (grupo dialout)?"},
                  address_.text, error.message());
    }
    serial_ = std::make_shared<Serial>(*this, std::move(raw));
    serial_->id = end_.open(Carrier::Packets, address_.text, steady_s());
    serial_->read();
    return {};
  }

  /// What happened may have left something to send, or somebody to close.
  void look() {
    const auto stirred = end_.take_stirred();
    for (std::size_t n = 0; n < stirred.size(); ++n) {
      const PeerId id = stirred[n];
      if (serial_ != nullptr && serial_->id == id) serial_->write();
      const auto found = sockets_.find(id);
      if (found == sockets_.end()) continue;
      const std::shared_ptr<Socket> connection = found->second;
      if (end_.gone(id)) {
        drop(*connection);
      } else {
        connection->write();
      }
    }
  }

  /// What that connection asked for takes long: it is read again when that is done.
  template <class Stream>
  void wait_for_work(Connection<Stream>& connection) {
    waiting_ = connection.id;
    read_again_ = [self = connection.shared_from_this()] { self->read(); };
    tick();
  }

  void drop(Socket& connection) {
    ErrorText ignored;
    connection.stream.close(ignored);
    if (sockets_.erase(connection.id) > 0) end_.lost(connection.id, steady_s());
  }
  void drop(Serial& connection) {
    ErrorText ignored;
    connection.stream.close(ignored);
    end_.lost(connection.id, steady_s());
    serial_.reset();
    reopen_s_ = steady_s() + kReopen_s;
  }

  /// Closing a socket with bytes still to be read would throw away our last word on its way.
  void linger(Socket& connection) {
    ErrorText ignored;
    connection.stream.shutdown(tcp::socket::shutdown_send, ignored);
    connection.lingering = true;
    connection.lingers_until_s = steady_s() + kLinger_s;
    lingering_.push_back(connection.shared_from_this());
    end_.lost(connection.id, steady_s());
  }
  void linger(Serial&) {}

  void end_lingering(double now_s) {
    std::erase_if(lingering_, [&](const std::shared_ptr<Socket>& one) {
      if (one->stream.is_open() && now_s < one->lingers_until_s && lingering_.size() < kMostLingering) return false;
      ErrorText ignored;
      one->stream.close(ignored);
      sockets_.erase(one->id);
      return true;
    });
  }

  void tick() {
    const double now_s = steady_s();
    end_.poll(now_s);
    if (read_again_ && !end_.waits(waiting_)) std::exchange(read_again_, nullptr)();
    end_lingering(now_s);
    if (reopen_s_ > 0 && now_s >= reopen_s_) reopen_s_ = open_serial() ? 0 : now_s + kReopen_s;
    if (accept_again_s_ > 0 && now_s >= accept_again_s_) {
      accept_again_s_ = 0;
      accept();
    }
    look();
    const double wait_s = std::clamp(end_.due_s() - steady_s(), 0.0, kRound_s);
    timer_.expires_after(std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(wait_s)));
    timer_.async_wait([this](const ErrorText& error) {
      if (!error) tick();
    });
  }

  static constexpr std::size_t kMostLingering = 256;

  RobotEnd& end_;
  Address address_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  asio::steady_timer timer_, accept_timer_;
  std::map<PeerId, std::shared_ptr<Socket>> sockets_;
  std::vector<std::shared_ptr<Socket>> lingering_;
  std::shared_ptr<Serial> serial_;
  double reopen_s_ = 0, accept_again_s_ = 0;  // 0: not needed
  PeerId waiting_ = 0;                        // for its work, if read_again_ is set
  std::function<void()> read_again_;
};

Server::Server(std::unique_ptr<Shell> shell) : shell_(std::move(shell)) {}
Server::~Server() = default;

Result<std::unique_ptr<Server>> Server::listen(RobotEnd& end, const Address& address) {
  auto shell = std::make_unique<Shell>(end, address);
  if (auto opened = shell->open(); !opened) return tl::unexpected<Error>(opened.error());
  return std::unique_ptr<Server>(new Server(std::move(shell)));
}

const Address& Server::address() const noexcept { return shell_->address(); }

void Server::serve(const std::function<bool()>& stop, const Sentence& reason) { shell_->serve(stop, reason); }

std::string random_token() {
  std::random_device source;
  return fmt::format("{:08x}{:08x}", source(), source());
}

}  // namespace ganglion::link
