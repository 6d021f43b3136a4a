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

bool find(bool good, const Sentence& finding) {
  tell({"{}  {}", "{}  {}"}, good ? Text{"ok ", "ok "} : Text{"BAD", "MAL"}, finding);
  return good;
}

int examine_robot(const std::string& text) {
  const auto address = link::parse_address(text);
  if (!address) return complain(address.error());
  const bool good =
      link::examine(link::make_line(*address), [](bool fine, const Sentence& finding) { find(fine, finding); });
  if (good) {
    tell({"A controller can drive it: ganglion run EXPERIMENT --robot {}",
          "Un controlador puede conducirlo: ganglion run EXPERIMENTO --robot {}"},
         address->text);
  } else {
    tell({"docs/link.md says what each message must hold.", "docs/link.md dice qué debe contener cada mensaje."});
  }
  return good ? kDone : kLinkLostCode;
}

int examine_installation() {
  tell({"ganglion {}, {} processors", "ganglion {}, {} procesadores"}, kVersion, std::thread::hardware_concurrency());
  bool good = true;
  const auto kinds = all_descriptors();
  good &=
      find(!kinds.empty(),
           !kinds.empty() ? say({"{} kinds of component are built in", "tiene {} tipos de componente"}, kinds.size())
                          : say({"no kinds are built in: build again from a clean checkout",
                                 "no tiene ningún tipo: compile de nuevo desde una copia limpia"}));
  // The value of the exact sine at 1 rounded to double; a CPU or library that differs gives other digests.
  const bool same = math::sin(1) == 0x1.aed548f090ceep-1;
  good &=
      find(same, same ? say({"deterministic functions give the expected bits",
                             "las funciones deterministas dan los bits esperados"})
                      : say({"sin(1) has unexpected bits: runs will not repeat those of other machines; which SLEEF "
                             "is installed?",
                             "sin(1) tiene bits inesperados: las ejecuciones no repetirán las de otras máquinas; ¿qué "
                             "SLEEF está instalado?"}));
  const bool writable = ::access(".", W_OK) == 0;
  good &= find(writable, writable ? say({"run files can be written below this folder (runs/)",
                                         "se pueden escribir ejecuciones bajo esta carpeta (runs/)"})
                                  : say({"this folder cannot be written: go to another, or give run --out DIR",
                                         "no se puede escribir en esta carpeta: vaya a otra, o dé run --out DIR"}));
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
