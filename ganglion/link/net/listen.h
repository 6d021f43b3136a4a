#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <string>

#include "ganglion/base/result.h"
#include "ganglion/link/net/address.h"

namespace ganglion::link {

/// Opens a fresh acceptor at a TCP address; port 0 becomes the one that was taken. For the sources that hold Boost
/// only.
inline Result<void> listen_at(boost::asio::ip::tcp::acceptor& acceptor, Address& address) {
  using boost::asio::ip::tcp;
  boost::system::error_code error;
  tcp::resolver resolver(acceptor.get_executor());
  const auto found = resolver.resolve(address.host, std::to_string(address.port), tcp::resolver::passive, error);
  if (!error) acceptor.open(found.begin()->endpoint().protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(found.begin()->endpoint(), error);
  if (!error) acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
  if (error) {
    return fail(ErrorCode::LinkLost,
                {"cannot listen at {}: {}. Is something else running there? Port 0 takes a free one",
                 "no se puede escuchar en {}: {}. ¿Hay otro programa ahí? El puerto 0 toma uno libre"},
                address.text, error.message());
  }
  address.port = acceptor.local_endpoint().port();
  address.text = tcp_text(address.host, address.port);
  address.open = !acceptor.local_endpoint().address().is_loopback();
  return {};
}

}  // namespace ganglion::link
