#include <unistd.h>

#include <thread>

#include "commands.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/link/controller/examination.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/math/functions.h"
#include "ganglion/run/version.h"
#include "say.h"

namespace ganglion {
namespace {

bool say(bool good, const std::string& what, const std::string& otherwise) {
  fmt::print("{}  {}\n", good ? "ok " : "BAD", good ? what : otherwise);
  return good;
}

int examine_robot(const std::string& text) {
  const auto address = link::parse_address(text);
  if (!address) return complain(address.error());
  const bool good = link::examine(link::make_line(*address),
                                  [](bool fine, const std::string& finding) { say(fine, finding, finding); });
  fmt::print("{}\n", good ? "A controller can drive it: ganglion run EXPERIMENT --robot " + address->text
                          : "docs/link.md says what each message must hold.");
  return good ? kDone : kLinkLostCode;
}

int examine_installation() {
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
  return good ? kDone : kBadInput;
}

}  // namespace

void add_doctor(CLI::App& program, int& code) {
  auto robot = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("doctor", "Check that this installation works, or a robot elsewhere, in plain words");
  command->add_option("--robot", *robot,
                      "tcp://HOST:PORT or serial:///dev/ttyUSB0?baud=115200: look at the robot there; it is not moved");
  command->footer("Example: ganglion doctor --robot tcp://127.0.0.1:7007");
  command->callback([robot, &code] { code = robot->empty() ? examine_installation() : examine_robot(*robot); });
}

}  // namespace ganglion
