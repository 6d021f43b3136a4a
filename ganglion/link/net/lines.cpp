#include "ganglion/link/net/lines.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/serial_port.hpp>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <optional>
#include <system_error>
#include <thread>

namespace ganglion::link {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

std::string reason_of(int error) { return std::generic_category().message(error); }

/// Reading and writing of a descriptor that does not block, with patience.
class DescriptorLine : public Line {
 public:
  explicit DescriptorLine(const Address& address) : address_(address) {}
  const std::string& address() const noexcept override { return address_.text; }
  double now_s() noexcept override { return steady_s(); }
  void wait_until(double until_s) override {
    const double left_s = until_s - steady_s();
    if (left_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
  }

  Result<void> send(std::string_view bytes, double until_s) override {
    while (!bytes.empty()) {
      const ssize_t sent = put(bytes);
      if (sent > 0) {
        bytes.remove_prefix(static_cast<std::size_t>(sent));
      } else if (errno != EAGAIN && errno != EINTR) {
        return fail(ErrorCode::LinkLost, {"{}: sending failed: {}", "{}: falló el envío: {}"}, address_.text,
                    reason_of(errno));
      } else if (steady_s() >= until_s) {
        return fail(ErrorCode::LinkLost,
                    {"{}: the other side takes no more bytes", "{}: el otro extremo no acepta más bytes"},
                    address_.text);
      } else {
        wait_for(POLLOUT, until_s);
      }
    }
    return {};
  }

  Result<std::size_t> receive(std::span<char> room, double until_s) override {
    if (!wait_for(POLLIN, until_s)) return std::size_t{0};
    const ssize_t got = ::read(descriptor(), room.data(), room.size());
    if (got > 0) return static_cast<std::size_t>(got);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return std::size_t{0};
    return fail(ErrorCode::LinkLost, {"{}: {}", "{}: {}"}, address_.text,
                got == 0 ? say({"the other side closed the connection", "el otro extremo cerró la conexión"})
                         : Sentence::quoted(reason_of(errno)));
  }

 protected:
  virtual int descriptor() noexcept = 0;
  virtual ssize_t put(std::string_view bytes) noexcept = 0;
  const Address address_;

 private:
  /// Whether the descriptor became ready in time; a signal ends the waiting early.
  bool wait_for(short events, double until_s) noexcept {
    pollfd one{descriptor(), events, 0};
    const double left_s = std::clamp(until_s - steady_s(), 0.0, 1e6);
    timespec patience{};
    patience.tv_sec = static_cast<time_t>(left_s);
    patience.tv_nsec = static_cast<long>((left_s - std::floor(left_s)) * 1e9);
    return ::ppoll(&one, 1, &patience, nullptr) > 0;
  }
};

class TcpLine final : public DescriptorLine {
 public:
  using DescriptorLine::DescriptorLine;
  Carrier carrier() const noexcept override {
    return address_.kind == Address::Kind::SerialOverTcp ? Carrier::Packets : Carrier::Stream;
  }

  Result<void> connect(double until_s) override {
    close();
    boost::system::error_code error;
    tcp::resolver resolver(context_);
    const auto found = resolver.resolve(address_.host, std::to_string(address_.port), error);
    if (error) {
      return fail(ErrorCode::LinkLost, {"{}: no such host: {}", "{}: no existe ese equipo: {}"}, address_.text,
                  error.message());
    }
    error = asio::error::timed_out;
    socket_.emplace(context_);
    asio::async_connect(*socket_, found,
                        [&error](const boost::system::error_code& result, const tcp::endpoint&) { error = result; });
    context_.restart();
    context_.run_for(std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::duration<double>(std::max(0.0, until_s - steady_s()))));
    if (!error) socket_->set_option(tcp::no_delay(true), error);
    if (!error) socket_->native_non_blocking(true, error);
    if (!error) return {};
    close();
    context_.restart();
    context_.poll();  // the connection attempt that was given up
    return fail(
        ErrorCode::LinkLost,
        {"nothing answers at {}: {}. Is the robot on? A simulated one is started by: ganglion sim EXPERIMENT "
         "--listen {}:{}",
         "nada responde en {}: {}. ¿Está encendido el robot? Uno simulado se inicia con: ganglion sim EXPERIMENTO "
         "--listen {}:{}"},
        address_.text, error.message(), address_.host, address_.port);
  }

  void close() noexcept override {
    boost::system::error_code ignored;
    if (socket_) socket_->close(ignored);
  }

 private:
  int descriptor() noexcept override { return socket_->native_handle(); }
  ssize_t put(std::string_view bytes) noexcept override {
    return ::send(descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  asio::io_context context_;
  std::optional<tcp::socket> socket_;
};

class SerialLine final : public DescriptorLine {
 public:
  using DescriptorLine::DescriptorLine;
  Carrier carrier() const noexcept override { return Carrier::Packets; }

  Result<void> connect(double) override {
    close();
    boost::system::error_code error;
    port_.emplace(context_);
    port_->open(address_.device, error);  // raw, 8 bits, no parity
    if (!error) port_->set_option(asio::serial_port::baud_rate(address_.baud), error);
    if (!error) return {};
    close();
    return fail(ErrorCode::LinkLost,
                {"{}: {}. Is it plugged in, and may you use it (group dialout)?",
                 "{}: {}. ¿Está enchufado, y puede usted usarlo (grupo dialout)?"},
                address_.text, error.message());
  }

  void close() noexcept override {
    boost::system::error_code ignored;
    if (port_) port_->close(ignored);
  }

 private:
  int descriptor() noexcept override { return port_->native_handle(); }
  ssize_t put(std::string_view bytes) noexcept override { return ::write(descriptor(), bytes.data(), bytes.size()); }

  asio::io_context context_;
  std::optional<asio::serial_port> port_;
};

}  // namespace

std::unique_ptr<Line> make_line(const Address& address) {
  if (address.kind == Address::Kind::Serial) return std::make_unique<SerialLine>(address);
  return std::make_unique<TcpLine>(address);
}

double steady_s() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace ganglion::link
