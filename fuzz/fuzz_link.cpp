// Both ends of the link, in the dialect that the build names: one program each for binary frames over TCP, JSON lines
// over TCP, and packets of a serial line. An input is a Script.
#include "fuzz/link/ends.h"
#include "fuzz/link/mutator.h"

namespace {

constexpr ganglion::fuzz::Dialect kDialect{ganglion::link::Carrier::GANGLION_FUZZ_CARRIER,
                                           ganglion::link::Encoding::GANGLION_FUZZ_ENCODING};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  return ganglion::fuzz::mutate_script(data, size, most, seed, kDialect);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto script = ganglion::fuzz::Script::parse({reinterpret_cast<const char*>(data), size});
  script.to_controller ? ganglion::fuzz::talk_to_controller(script, kDialect)
                       : ganglion::fuzz::talk_to_robot(script, kDialect);
  return 0;
}
