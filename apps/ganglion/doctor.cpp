#include <unistd.h>

#include <thread>

#include "commands.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/math/functions.h"
#include "ganglion/run/version.h"

namespace ganglion {
namespace {

bool say(bool good, const std::string& what, const std::string& otherwise) {
  fmt::print("{}  {}\n", good ? "ok " : "BAD", good ? what : otherwise);
  return good;
}

}  // namespace

void add_doctor(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand("doctor", "Check that this installation works, in plain words");
  command->callback([&code] {
    fmt::print("ganglion {}, {} processors\n", kVersion, std::thread::hardware_concurrency());
    bool good = true;
    const auto kinds = all_descriptors();
    good &= say(!kinds.empty(), fmt::format("{} kinds of component are built in", kinds.size()),
                "no kinds are built in: build again from a clean checkout");
    // The value of the exact sine at 1 rounded to double; a CPU or library that differs gives other digests.
    good &= say(math::sin(1) == 0x1.aed548f090ceep-1, "deterministic functions give the expected bits",
                "sin(1) has unexpected bits: runs will not repeat those of other machines; which SLEEF is installed?");
    const bool writable = ::access(".", W_OK) == 0;
    good &= say(writable, "run files can be written below this folder (runs/)",
                "this folder cannot be written: go to another, or give run --out DIR");
    code = good ? kDone : kBadInput;
  });
}

}  // namespace ganglion
