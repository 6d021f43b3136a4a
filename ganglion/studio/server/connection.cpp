#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "ganglion/base/text.h"
#include "ganglion/studio/api/query.h"
#include "ganglion/studio/server/core.h"

namespace ganglion::studio {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Code = beast::error_code;

constexpr std::uint32_t kHeadBytes = 16 << 10;
constexpr std::uint64_t kBodyBytes = 8 << 20;
constexpr std::size_t kFrameBytes = 64 << 10;
constexpr auto kHeadTime = std::chrono::seconds(10);  // a whole head must come within it, however slowly
constexpr auto kBodyTime = std::chrono::seconds(30);
constexpr auto kSendTime = std::chrono::seconds(60);
constexpr std::string_view kProtocol = "ganglion.studio.v1";
constexpr std::uint16_t kTooFarBehind = 4001;

constexpr std::string_view kPagePolicy =
    "default-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'; object-src 'none'";
/// Of a report: its own scripts run, in an origin of its own that reaches nothing.
constexpr std::string_view kReportPolicy =
    "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// The one that a browser names first, as in "es-ES,es;q=0.8", where we speak it.
Language language_of(std::string_view accepted) {
  return accepted.substr(0, accepted.find_first_of("-,; ")) == "es" ? Language::Spanish : Language::English;
}

/// One onlooker's WebSocket. What he sends is read, for its limits, and means nothing.
class Watch : public std::enable_shared_from_this<Watch> {
 public:
  Watch(ServerCore& core, beast::tcp_stream stream, std::uint64_t id)
      : core_(core), socket_(std::move(stream)), id_(id) {}
  ~Watch() { core_.connections.remove(id_); }

  void start(const http::request<http::string_body>& request) {
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_.read_message_max(kFrameBytes);
    const bool named = view(request[http::field::sec_websocket_protocol]).find(kProtocol) != std::string_view::npos;
    socket_.set_option(websocket::stream_base::decorator([named](websocket::response_type& response) {
      if (named)
        response.set(http::field::sec_websocket_protocol, beast::string_view(kProtocol.data(), kProtocol.size()));
    }));
    const std::string target(view(request.target()));
    socket_.async_accept(request, [self = shared_from_this(), target](Code error) {
      if (!error) self->begin(target);
    });
  }
  void drop() { beast::get_lowest_layer(socket_).close(); }

 private:
  void begin(const std::string& target) {
    viewer_ = std::make_unique<Viewer>(core_.hub, [this] { pump(); });
    const auto session = query_value(target, "session");
    const auto after = parse_number(query_value(target, "after").value_or(""));
    if (session && after && *after >= 0 && *after < 1e15) {
      viewer_->resume(*session, static_cast<std::uint64_t>(*after));
    }
    if (query_value(target, "bundles") == "1") viewer_->bundle_rows();
    read();
    pump();
  }

  void read() {
    socket_.async_read(incoming_, [self = shared_from_this()](Code error, std::size_t) {
      if (error) return self->end();
      self->incoming_.consume(self->incoming_.size());
      self->read();
    });
  }

  /// Sends one message after the other as fast as he takes them.
  void pump() {
    if (writing_ || !viewer_) return;
    auto out = viewer_->next();
    if (!out) {
      if (viewer_->lost()) close();
      return;
    }
    writing_ = true;
    socket_.binary(out->binary);
    const auto buffer = asio::buffer(*out->bytes);
    socket_.async_write(buffer, [self = shared_from_this(), bytes = out->bytes](Code error, std::size_t) {
      self->writing_ = false;
      if (error) return self->end();
      self->pump();
    });
  }

  void close() {
    viewer_.reset();
    writing_ = true;
    const websocket::close_reason reason(static_cast<websocket::close_code>(kTooFarBehind), "too far behind");
    socket_.async_close(reason, [self = shared_from_this()](Code) {});
  }

  void end() {
    viewer_.reset();
    drop();
  }

  ServerCore& core_;
  websocket::stream<beast::tcp_stream> socket_;
  const std::uint64_t id_;
  beast::flat_buffer incoming_{kFrameBytes + 1024};
  std::unique_ptr<Viewer> viewer_;
  bool writing_ = false;
};

/// One HTTP connection, request after request.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(ServerCore& core, tcp::socket socket) : core_(core), stream_(std::move(socket)) {}
  ~HttpConnection() {
    if (!handed_over_) core_.connections.remove(id_);
  }

  void start() {
    id_ = core_.connections.add([weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->stream_.close();
    });
    Code ignored;
    stream_.socket().set_option(tcp::no_delay(true), ignored);
    read_head();
  }

 private:
  using Request = http::request<http::string_body>;

  void read_head() {
    parser_.emplace();
    parser_->header_limit(kHeadBytes);
    parser_->body_limit(kBodyBytes);
    stream_.expires_after(kHeadTime);
    http::async_read_header(stream_, buffer_, *parser_, [self = shared_from_this()](Code error, std::size_t) {
      if (error) return self->refuse_broken(error);
      self->let_in();
    });
  }

  void refuse_broken(Code error) {
    keep_ = false;
    if (error == http::error::header_limit) {
      return refuse("TooLarge", say({"the header is too large", "el encabezado es demasiado grande"}), 431);
    }
    if (error == http::error::body_limit) {
      return refuse("TooLarge", say({"the body is larger than 8 MiB", "el cuerpo pasa de 8 MiB"}), 413);
    }
    const bool gone = error == http::error::end_of_stream || error == beast::error::timeout ||
                      error == http::error::partial_message || error.category() == boost::system::system_category();
    if (gone || error == asio::error::eof || error == asio::error::operation_aborted) return;
    refuse("BadRequest", say({"this is no HTTP", "esto no es HTTP"}), 400);
  }

  void let_in() {
    const Request& request = parser_->get();
    method_ = std::string(view(request.method_string()));
    language_ = language_of(view(request[http::field::accept_language]));
    keep_ = request.keep_alive();
    RequestHead head;
    head.method = method_;
    head.target = view(request.target());
    head.host = view(request[http::field::host]);
    head.hosts = static_cast<int>(request.count(http::field::host));
    head.origin = view(request[http::field::origin]);
    head.origins = static_cast<int>(request.count(http::field::origin));
    head.cookies = view(request[http::field::cookie]);
    head.authorization = view(request[http::field::authorization]);
    head.fetch_site = view(request["Sec-Fetch-Site"]);
    head.upgrade = websocket::is_upgrade(request);
    const Verdict verdict = judge(core_.guard, head);
    if (verdict.status == 303) {
      core_.connections.admit(id_);
      return redirect(verdict.location);
    }
    if (verdict.status != 200) {
      keep_ = false;  // what else it sends is not read
      return refuse(verdict.status == 421   ? "WrongHost"
                    : verdict.status == 401 ? "Unauthorized"
                                            : "Forbidden",
                    verdict.why, verdict.status);
    }
    core_.connections.admit(id_);
    const auto encoding = request[http::field::transfer_encoding];
    if (!encoding.empty() && !beast::iequals(encoding, "chunked")) {
      keep_ = false;  // where its body ends is not known
      return refuse("BadRequest",
                    say({"of transfer encodings only chunked is known",
                         "de las codificaciones de transferencia solo se conoce chunked"}),
                    501);
    }
    if (head.upgrade) return upgrade();
    if (beast::iequals(request[http::field::expect], "100-continue")) return go_on();
    read_body();
  }

  void go_on() {
    static constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
    asio::async_write(stream_, asio::buffer(kContinue), [self = shared_from_this()](Code error, std::size_t) {
      if (!error) self->read_body();
    });
  }

  void upgrade() {
    Request request = parser_->release();
    const std::string path =
        percent_decoded(view(request.target()).substr(0, view(request.target()).find('?'))).value_or("");
    if (path != "/ws") {
      return refuse("UnknownPath", say({"there is no WebSocket at this path", "aquí no hay ningún WebSocket"}), 404);
    }
    if (!core_.connections.watch(id_)) {
      return refuse("TooLarge", say({"there are viewers enough", "ya hay bastantes espectadores"}), 503);
    }
    handed_over_ = true;
    core_.connections.remove(id_);
    const auto place = std::make_shared<std::weak_ptr<Watch>>();
    const std::uint64_t id = core_.connections.add([place] {
      if (const auto watch = place->lock()) watch->drop();
    });
    core_.connections.admit(id);
    core_.connections.watch(id);
    const auto watch = std::make_shared<Watch>(core_, std::move(stream_), id);
    *place = watch;
    watch->start(request);
  }

  void read_body() {
    stream_.expires_after(kBodyTime);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](Code error, std::size_t) {
      if (error) return self->refuse_broken(error);
      self->answer();
    });
  }

  void answer() {
    const Request& request = parser_->get();
    Call call{method_, "", std::string(view(request.target())), request.body(), language_};
    const auto path = percent_decoded(std::string_view(call.target).substr(0, call.target.find('?')));
    if (!path || !path->starts_with('/')) {
      return refuse("BadRequest", say({"the path is badly encoded", "la ruta está mal codificada"}), 400);
    }
    call.path = *path;
    if (!call.path.starts_with("/api/")) return send_asset(call.path);
    stream_.expires_never();  // the answer takes what it takes
    asio::post(core_.worker, [self = shared_from_this(), call = std::move(call)] {
      unless_denied([&] {
        Reply reply = self->core_.api->handle(call);
        asio::post(self->core_.io, [self, reply = std::move(reply)]() mutable { self->send(std::move(reply)); });
      });
    });
  }

  void send_asset(const std::string& path) {
    if (method_ != "GET" && method_ != "HEAD") return refuse("BadRequest", takes_only("GET"), 405);
    const bool packed = view(parser_->get()[http::field::accept_encoding]).find("gzip") != std::string_view::npos;
    auto asset = core_.assets.find(path, packed);
    if (!asset) return refuse("UnknownPath", nothing_there(), 404);
    packed_ = asset->gzip;
    send({200, std::move(asset->type), std::move(asset->body)});
  }

  void redirect(const std::string& location) {
    keep_ = false;
    auto response = make_response({303, "text/plain", ""});
    response->set(http::field::location, location);
    response->set(http::field::set_cookie,
                  fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", core_.guard.cookie, core_.guard.session));
    write(std::move(response));
  }

  using Response = http::response<http::string_body>;
  std::shared_ptr<Response> make_response(Reply reply) {
    auto response = std::make_shared<Response>(static_cast<http::status>(reply.status), 11);
    response->set(http::field::server, "ganglion");
    response->set(http::field::content_type, reply.type);
    const std::string_view policy = reply.sandboxed ? kReportPolicy : kPagePolicy;
    response->set("Content-Security-Policy", beast::string_view(policy.data(), policy.size()));
    response->set("X-Content-Type-Options", "nosniff");
    response->set("Referrer-Policy", "no-referrer");
    response->set("Cross-Origin-Resource-Policy", "same-origin");
    response->set("Cross-Origin-Opener-Policy", "same-origin");
    response->set(http::field::cache_control, "no-store");
    if (std::exchange(packed_, false)) response->set(http::field::content_encoding, "gzip");
    response->keep_alive(keep_);
    const std::size_t size = reply.body.size();
    if (method_ != "HEAD") response->body() = std::move(reply.body);
    response->content_length(size);
    return response;
  }

  void send(Reply reply) { write(make_response(std::move(reply))); }
  void refuse(std::string_view code, const Sentence& what, unsigned status) {
    send(failure(code, what, language_, status));
  }

  void write(std::shared_ptr<Response> response) {
    stream_.expires_after(kSendTime);
    const auto serializer = std::make_shared<http::response_serializer<http::string_body>>(*response);
    const auto done = [self = shared_from_this(), response, serializer](Code error, std::size_t) {
      if (error) return;
      if (self->keep_) return self->read_head();
      self->linger();
    };
    if (method_ == "HEAD") {
      http::async_write_header(stream_, *serializer, done);
    } else {
      http::async_write(stream_, *serializer, done);
    }
  }

  /// Reads off what is still coming, for a while: else the answer could be lost with the connection.
  void linger() {
    Code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    stream_.expires_after(std::chrono::seconds(2));
    waste();
  }
  void waste() {
    buffer_.clear();
    stream_.async_read_some(buffer_.prepare(16 << 10), [self = shared_from_this()](Code error, std::size_t got) {
      self->wasted_ += got;
      if (!error && self->wasted_ < 2 * kBodyBytes) self->waste();
    });
  }

  ServerCore& core_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{kHeadBytes + (64 << 10)};
  std::optional<http::request_parser<http::string_body>> parser_;
  std::string method_;
  Language language_ = Language::English;
  std::uint64_t id_ = 0;
  std::uint64_t wasted_ = 0;
  bool keep_ = false;
  bool packed_ = false;
  bool handed_over_ = false;
};

}  // namespace

void serve_connection(ServerCore& core, tcp::socket socket) {
  std::make_shared<HttpConnection>(core, std::move(socket))->start();
}

}  // namespace ganglion::studio
