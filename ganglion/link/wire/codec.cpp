#include "ganglion/link/wire/codec.h"

#include <google/protobuf/util/json_util.h>

#include <array>

#include "ganglion/base/text.h"

namespace ganglion::link {
namespace {

namespace util = google::protobuf::util;

constexpr std::array<std::string_view, 10> kNames = {"Unknown", "Hello", "Describe", "Sense", "Act",
                                                     "Step",    "Event", "Reset",    "Bye",   "Beat"};
constexpr std::array<std::string_view, 10> kKeys = {"",     "hello", "describe", "sense", "act",
                                                    "step", "event", "reset",    "bye",   "beat"};
constexpr int kLengthDelimited = 2;  // wire type of messages

google::protobuf::Message* message_of(FrameKind kind, Messages& messages) noexcept {
  switch (kind) {
    case FrameKind::Hello:
      return &messages.hello;
    case FrameKind::Describe:
      return &messages.describe;
    case FrameKind::Sense:
      return &messages.sense;
    case FrameKind::Act:
      return &messages.act;
    case FrameKind::Step:
      return &messages.step;
    case FrameKind::Event:
      return &messages.event;
    case FrameKind::Reset:
      return &messages.reset;
    case FrameKind::Bye:
      return &messages.bye;
    case FrameKind::Beat:
      return &messages.beat;
    case FrameKind::Unknown:
      break;
  }
  return nullptr;
}

/// Takes the message out of a decoded wire::Frame.
FrameKind unwrap(Messages& messages) {
  const auto kind = static_cast<FrameKind>(messages.frame.kind_case());
  google::protobuf::Message* into = message_of(kind, messages);
  if (into == nullptr) return FrameKind::Unknown;
  const auto* field = messages.frame.GetDescriptor()->FindFieldByNumber(static_cast<int>(kind));
  into->GetReflection()->Swap(into, messages.frame.GetReflection()->MutableMessage(&messages.frame, field));
  return kind;
}

/// Reads a variable-length number of at most 4 bytes; none at a longer one.
std::optional<std::size_t> read_short_varint(std::string_view bytes, std::size_t& at) noexcept {
  std::size_t value = 0;
  for (int shift = 0; shift < 28 && at < bytes.size(); shift += 7) {
    const auto byte = static_cast<unsigned char>(bytes[at++]);
    value |= std::size_t{byte & 0x7Fu} << shift;
    if (byte < 0x80) return value;
  }
  return std::nullopt;
}

Result<FrameKind> decode_binary(std::string_view payload, Messages& into) {
  std::size_t at = 1;
  const unsigned tag = payload.empty() ? 0 : static_cast<unsigned char>(payload[0]);
  google::protobuf::Message* message = message_of(static_cast<FrameKind>(tag >> 3), into);
  const auto length = read_short_varint(payload, at);
  if ((tag & 7) == kLengthDelimited && message != nullptr && length && at + *length == payload.size()) {
    if (!message->ParseFromArray(payload.data() + at, static_cast<int>(*length))) {
      return fail(ErrorCode::Syntax, {"this is no {} frame of protocol 1", "esto no es una trama {} del protocolo 1"},
                  kNames[tag >> 3]);
    }
    return static_cast<FrameKind>(tag >> 3);
  }
  if (!into.frame.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) {
    return fail(ErrorCode::Syntax,
                {"a binary frame of {} bytes is no message of protocol 1",
                 "una trama binaria de {} bytes no es un mensaje del protocolo 1"},
                payload.size());
  }
  return unwrap(into);
}

Result<FrameKind> decode_json(std::string_view payload, Messages& into) {
  util::JsonParseOptions options;
  options.ignore_unknown_fields = true;
  into.frame.Clear();
  const auto status = util::JsonStringToMessage({payload.data(), payload.size()}, &into.frame, options);
  if (!status.ok()) {
    return fail(ErrorCode::Syntax, {"a JSON line cannot be read: {}", "no se puede leer una línea JSON: {}"},
                printable(std::string_view(status.message().data(), status.message().size()), 200));
  }
  return unwrap(into);
}

Result<void> write_json(FrameKind kind, const google::protobuf::Message& message, std::string& payload) {
  util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  std::string json;
  if (!util::MessageToJsonString(message, &json, options).ok()) {
    return fail(ErrorCode::BadParameter,
                {"a {} frame holds text that is no UTF-8", "una trama {} contiene texto que no es UTF-8"},
                name_of(kind));
  }
  payload = fmt::format("{{\"{}\":{}}}", kKeys[static_cast<std::size_t>(kind)], json);
  return {};
}

void write_binary(FrameKind kind, const google::protobuf::MessageLite& message, std::string& payload) {
  const std::size_t size = message.ByteSizeLong();
  payload.clear();
  payload += static_cast<char>(static_cast<unsigned>(kind) << 3 | kLengthDelimited);
  for (std::size_t rest = size;; rest >>= 7) {
    payload += static_cast<char>((rest & 0x7F) | (rest > 0x7F ? 0x80 : 0));
    if (rest <= 0x7F) break;
  }
  const std::size_t begin = payload.size();
  payload.resize(begin + size);
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(payload.data() + begin));
}

}  // namespace

std::string_view name_of(FrameKind kind) noexcept { return kNames[static_cast<std::size_t>(kind)]; }

Result<FrameKind> decode(std::string_view payload, Encoding encoding, Messages& into) {
  // What is wrong with a frame is told by our own Result; whoever sends us rubbish must not fill somebody's screen.
  static google::protobuf::LogHandler* const silenced = google::protobuf::SetLogHandler(nullptr);
  static_cast<void>(silenced);
  return encoding == Encoding::Json ? decode_json(payload, into) : decode_binary(payload, into);
}

Result<void> FrameWriter::append_as(FrameKind kind, const google::protobuf::Message& message, std::string& out) {
  if (message.ByteSizeLong() > kMaxFrameBytes) {
    return fail(ErrorCode::TooLarge,
                {"a {} frame would have {} bytes; the limit is {}", "una trama {} tendría {} bytes; el límite es {}"},
                name_of(kind), message.ByteSizeLong(), kMaxFrameBytes);
  }
  if (encoding_ == Encoding::Json) {
    if (auto written = write_json(kind, message, payload_); !written) return written;
  } else {
    write_binary(kind, message, payload_);
  }
  if (payload_.size() > kMaxFrameBytes) {
    return fail(ErrorCode::TooLarge,
                {"a {} frame would have {} bytes; the limit is {}", "una trama {} tendría {} bytes; el límite es {}"},
                name_of(kind), payload_.size(), kMaxFrameBytes);
  }
  append_frame(payload_, carrier_, encoding_, out);
  return {};
}

}  // namespace ganglion::link
