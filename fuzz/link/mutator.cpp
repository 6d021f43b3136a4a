#include "fuzz/link/mutator.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <random>

#include "ganglion/link/wire/cobs.h"
#include "ganglion/link/wire/link.pb.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace ganglion::fuzz {
namespace {

namespace pb = google::protobuf;
using Random = std::minstd_rand;

constexpr std::size_t kGrowth = 64;
constexpr std::array kNumbers = {0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 0.5,
                                 1.5,
                                 -1e300,
                                 1e-300,
                                 0.04,
                                 3600.0,
                                 3601.0,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()};
constexpr std::array<std::uint32_t, 12> kCounts = {0, 1, 2, 3, 40, 127, 128, 255, 500, 1000, 1001, 0xFFFFFFFF};

std::size_t below(Random& random, std::size_t count) { return random() % count; }

void scramble(std::string& text) {
  const std::size_t size = text.size();
  text.resize(size + kGrowth);
  text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
}

/// What the frame carries; none where it is broken.
std::optional<std::string> unframed(const std::string& bytes, const Dialect& dialect) {
  if (dialect.carrier == link::Carrier::Packets) {
    if (bytes.empty() || bytes.back() != 0) return std::nullopt;
    std::string packet = bytes.substr(0, bytes.size() - 1);
    std::string_view payload;
    if (!link::open_packet(packet, payload)) return std::nullopt;
    return std::string(payload);
  }
  if (dialect.encoding == link::Encoding::Json) {
    if (bytes.empty() || bytes.back() != '\n') return std::nullopt;
    return bytes.substr(0, bytes.size() - 1);
  }
  if (bytes.size() < 4) return std::nullopt;
  return bytes.substr(4);
}

std::string framed(std::string payload, const Dialect& dialect) {
  if (dialect.carrier == link::Carrier::Stream && dialect.encoding == link::Encoding::Json) {
    std::replace(payload.begin(), payload.end(), '\n', ' ');
  }
  std::string bytes;
  link::append_frame(payload, dialect.carrier, dialect.encoding, bytes);
  return bytes;
}

bool is_json(const std::string& payload) { return payload.starts_with('{'); }

bool read(const std::string& payload, link::wire::Frame& frame) {
  if (!is_json(payload)) return frame.ParseFromString(payload);
  return pb::util::JsonStringToMessage(payload, &frame).ok();
}

std::string written(const link::wire::Frame& frame, bool json) {
  if (!json) return frame.SerializeAsString();
  pb::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  std::string text;
  static_cast<void>(pb::util::MessageToJsonString(frame, &text, options));
  return text;
}

double number(Random& random, double now) {
  return below(random, 4) == 0 ? now * 1.5 : kNumbers[below(random, kNumbers.size())];
}
std::uint32_t count(Random& random, std::uint32_t now) {
  const std::size_t kind = below(random, 4);
  return kind == 0 ? now + 1 : kind == 1 ? now - 1 : kCounts[below(random, kCounts.size())];
}

void change(pb::Message& message, Random& random);

/// Changes one field that stands alone.
void change_one(pb::Message& message, const pb::FieldDescriptor& field, Random& random) {
  const pb::Reflection& way = *message.GetReflection();
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return way.SetDouble(&message, &field, number(random, way.GetDouble(message, &field)));
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return way.SetFloat(&message, &field, static_cast<float>(number(random, way.GetFloat(message, &field))));
    case pb::FieldDescriptor::CPPTYPE_UINT32:
      return way.SetUInt32(&message, &field, count(random, way.GetUInt32(message, &field)));
    case pb::FieldDescriptor::CPPTYPE_UINT64:
      return way.SetUInt64(&message, &field, count(random, static_cast<std::uint32_t>(way.GetUInt64(message, &field))));
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return way.SetInt32(&message, &field, static_cast<std::int32_t>(count(random, 0)));
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return way.SetBool(&message, &field, !way.GetBool(message, &field));
    case pb::FieldDescriptor::CPPTYPE_ENUM:
      return way.SetEnumValue(&message, &field, static_cast<int>(below(random, 4)));
    case pb::FieldDescriptor::CPPTYPE_STRING: {
      std::string text = way.GetString(message, &field);
      below(random, 3) == 0 ? text.clear() : scramble(text);
      for (char& byte : text) byte = static_cast<char>(byte & 0x7F);  // else it is no UTF-8
      return way.SetString(&message, &field, std::move(text));
    }
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return change(*way.MutableMessage(&message, &field), random);
    default:
      return;
  }
}

void add(pb::Message& message, const pb::FieldDescriptor& field, Random& random) {
  const pb::Reflection& way = *message.GetReflection();
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return way.AddDouble(&message, &field, number(random, 1));
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return way.AddFloat(&message, &field, static_cast<float>(number(random, 1)));
    case pb::FieldDescriptor::CPPTYPE_UINT32:
      return way.AddUInt32(&message, &field, count(random, 1));
    case pb::FieldDescriptor::CPPTYPE_STRING:
      return way.AddString(&message, &field, "more");
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return change(*way.AddMessage(&message, &field), random);
    default:
      return;
  }
}

/// Changes one entry of a list, or how many there are.
void change_list(pb::Message& message, const pb::FieldDescriptor& field, Random& random) {
  const pb::Reflection& way = *message.GetReflection();
  const int size = way.FieldSize(message, &field);
  const std::size_t kind = below(random, 6);
  if (size == 0 || kind == 0) return add(message, field, random);
  if (kind == 1) return way.RemoveLast(&message, &field);
  const int at = static_cast<int>(below(random, static_cast<std::size_t>(size)));
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return way.SetRepeatedDouble(&message, &field, at, number(random, way.GetRepeatedDouble(message, &field, at)));
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return way.SetRepeatedFloat(&message, &field, at, static_cast<float>(number(random, 1)));
    case pb::FieldDescriptor::CPPTYPE_UINT32:
      return way.SetRepeatedUInt32(&message, &field, at, count(random, way.GetRepeatedUInt32(message, &field, at)));
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return change(*way.MutableRepeatedMessage(&message, &field, at), random);
    default:
      return;
  }
}

/// Changes one field of a message, or of one within it.
void change(pb::Message& message, Random& random) {
  const pb::Descriptor& type = *message.GetDescriptor();
  if (type.field_count() == 0) return;
  std::vector<const pb::FieldDescriptor*> filled;
  message.GetReflection()->ListFields(message, &filled);
  const bool among_filled = !filled.empty() && below(random, 3) > 0;
  const pb::FieldDescriptor& field =
      among_filled ? *filled[below(random, filled.size())]
                   : *type.field(static_cast<int>(below(random, static_cast<std::size_t>(type.field_count()))));
  field.is_repeated() ? change_list(message, field, random) : change_one(message, field, random);
}

/// A frame again, with one field of its message changed; at times it becomes another message.
void change_message(std::string& bytes, const Dialect& dialect, Random& random) {
  const auto payload = unframed(bytes, dialect);
  link::wire::Frame frame;
  if (!payload || !read(*payload, frame)) return scramble(bytes);
  const auto* kind = frame.GetReflection()->GetOneofFieldDescriptor(frame, frame.GetDescriptor()->oneof_decl(0));
  if (kind == nullptr || below(random, 20) == 0) {
    change(frame, random);
  } else {
    for (std::size_t left = 1 + below(random, 3); left > 0; --left) {
      change(*frame.GetReflection()->MutableMessage(&frame, kind), random);
    }
  }
  bytes = framed(written(frame, is_json(*payload)), dialect);
}

/// A frame again, with the bytes of its payload changed.
void change_payload(std::string& bytes, const Dialect& dialect) {
  auto payload = unframed(bytes, dialect);
  if (!payload) return scramble(bytes);
  scramble(*payload);
  bytes = framed(std::move(*payload), dialect);
}

void change_order(Script& script, Random& random) {
  auto& pieces = script.pieces;
  const std::size_t at = below(random, pieces.size()), other = below(random, pieces.size());
  switch (below(random, 5)) {
    case 0:
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(at));
      return;
    case 1:
      std::swap(pieces[at], pieces[other]);
      return;
    case 2:
      pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(other), {0, ""});
      return;
    default: {
      const Script::Piece copy = pieces[at];
      pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(other), copy);
    }
  }
}

void change_script(Script& script, const Dialect& dialect, Random& random) {
  if (script.pieces.empty()) script.pieces.push_back({0, framed("{\"hello\":{\"major\":1}}", dialect)});
  Script::Piece& piece = script.pieces[below(random, script.pieces.size())];
  switch (below(random, 16)) {
    case 0:
      return scramble(piece.bytes);  // a length or checksum may become wrong
    case 1:
      script.free_running = !script.free_running;
      return;
    case 2:
      script.deaf = !script.deaf;
      return;
    case 3:
    case 4:
      piece.wait = static_cast<std::uint8_t>(below(random, 3) == 0 ? below(random, 256) : below(random, 30));
      return;
    case 5:
    case 6:
    case 7:
      return change_order(script, random);
    case 8:
    case 9:
      return change_payload(piece.bytes, dialect);
    default:
      return change_message(piece.bytes, dialect, random);
  }
}

}  // namespace

std::size_t mutate_script(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed,
                          const Dialect& dialect) {
  Random random(seed + 1);
  random.discard(3);
  if (below(random, 50) == 0) return LLVMFuzzerMutate(data, size, most);
  Script script = Script::parse({reinterpret_cast<const char*>(data), size});
  for (std::size_t left = 1 + below(random, 3); left > 0; --left) change_script(script, dialect, random);
  const std::string text = script.text();
  if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(text.begin(), text.end(), data);
  return text.size();
}

}  // namespace ganglion::fuzz
