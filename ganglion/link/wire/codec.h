#pragma once

#include "ganglion/link/wire/framing.h"
#include "ganglion/link/wire/link.pb.h"

namespace ganglion::link {

/// Which message a frame carries; the number is that of its field in wire::Frame.
enum class FrameKind : std::uint8_t {
  Unknown = 0,  ///< Of a later minor version: to be ignored.
  Hello = 1,
  Describe = 2,
  Sense = 3,
  Act = 4,
  Step = 5,
  Event = 6,
  Reset = 7,
  Bye = 8,
  Beat = 9,
};
/// "Hello".
std::string_view name_of(FrameKind kind) noexcept;

/// The last message of each kind that was decoded. They keep their memory, so that a warm stream of binary Sense and
/// Act frames takes none.
struct Messages {
  wire::Hello hello;
  wire::Describe describe;
  wire::Sense sense;
  wire::Act act;
  wire::Step step;
  wire::Event event;
  wire::Reset reset;
  wire::Bye bye;
  wire::Beat beat;
  wire::Frame frame;  ///< Only of frames in JSON, or oddly written.
};

constexpr FrameKind kind_of(const wire::Hello&) noexcept { return FrameKind::Hello; }
constexpr FrameKind kind_of(const wire::Describe&) noexcept { return FrameKind::Describe; }
constexpr FrameKind kind_of(const wire::Sense&) noexcept { return FrameKind::Sense; }
constexpr FrameKind kind_of(const wire::Act&) noexcept { return FrameKind::Act; }
constexpr FrameKind kind_of(const wire::Step&) noexcept { return FrameKind::Step; }
constexpr FrameKind kind_of(const wire::Event&) noexcept { return FrameKind::Event; }
constexpr FrameKind kind_of(const wire::Reset&) noexcept { return FrameKind::Reset; }
constexpr FrameKind kind_of(const wire::Bye&) noexcept { return FrameKind::Bye; }
constexpr FrameKind kind_of(const wire::Beat&) noexcept { return FrameKind::Beat; }

/// Reads one frame into the message of its kind. Fails with Syntax.
Result<FrameKind> decode(std::string_view payload, Encoding encoding, Messages& into);

/// Writes frames, reusing its memory. Fails with TooLarge beyond kMaxFrameBytes; then nothing is appended.
class FrameWriter {
 public:
  FrameWriter(Carrier carrier, Encoding encoding) : carrier_(carrier), encoding_(encoding) {}
  Encoding encoding() const noexcept { return encoding_; }
  template <class Message>
  Result<void> append(const Message& message, std::string& out) {
    return append_as(kind_of(message), message, out);
  }

 private:
  Result<void> append_as(FrameKind kind, const google::protobuf::Message& message, std::string& out);

  Carrier carrier_;
  Encoding encoding_;
  std::string payload_;
};

}  // namespace ganglion::link
