#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "commands.h"
#include "ganglion/run/version.h"
#include "interrupt.h"
#include "language.h"

namespace {

/// Whatever is denied to the program on the way, it ends in words.
int refuse(ganglion::Text words, const char* what = "") {
  const std::string_view text = words.in(ganglion::language());
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fputs(what, stderr);
  std::fputc('\n', stderr);
  return ganglion::kBadInput;
}

/// In words, what was thrown and nobody caught.
int refuse_thrown() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return refuse({"out of memory: take fewer robots, threads or seeds, or a smaller world",
                   "no queda memoria: tome menos robots, hilos o semillas, o un mundo más pequeño"});
  } catch (const std::system_error& error) {
    return refuse(
        {"the system refuses what is needed (threads, descriptors): end other programs, or take fewer threads: ",
         "el sistema niega lo necesario (hilos, descriptores): cierre otros programas o tome menos hilos: "},
        error.what());
  } catch (const std::exception& error) {
    return refuse({"this is a fault of the program, please report it: ", "es un error del programa, por favor avise: "},
                  error.what());
  }
}

/// Where it was thrown in a thread of its own, or on the way out of what must not throw (some libraries), nothing can be
/// tidied up any more.
[[noreturn]] void end_in_words() noexcept {
  if (std::current_exception() != nullptr) std::_Exit(refuse_thrown());
  std::_Exit(refuse({"this is a fault of the program, please report it: it ended where it must not",
                     "es un error del programa, por favor avise: terminó donde no debe"}));
}

int carry_out(int argc, char** argv) {
  ganglion::report_full_files();
  ganglion::choose_language(argc, argv);
  CLI::App program{"Ganglion: design, grow, run and measure controllers for small mobile robots", "ganglion"};
  program.set_version_flag("--version", std::string(ganglion::kVersion));
  program.require_subcommand(1);
  program.footer(
      "Examples:\n"
      "  ganglion run experiments/nimrod --seed 7\n"
      "  ganglion run experiments/nimrod --seeds 1..100 --json\n"
      "  ganglion check experiments/nimrod/controller.toml\n"
      "Exit codes: 0 done, 1 the robot failed its task, 2 bad input, 3 link to the robot lost, 4 output failed.");
  int code = ganglion::kDone;
  ganglion::add_run(program, code);
  ganglion::add_sim(program, code);
  ganglion::add_proxy(program, code);
  ganglion::add_check(program, code);
  ganglion::add_format(program, code);
  ganglion::add_kinds(program, code);
  ganglion::add_doctor(program, code);
  ganglion::add_replay(program, code);
  ganglion::add_plot(program, code);
  ganglion::add_runs(program, code);
  ganglion::add_experience(program, code);
  ganglion::add_schema(program, code);
  ganglion::add_studio(program, code);
  ganglion::offer_languages(program);
  program.failure_message(ganglion::refusal);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = program.exit(error);
    return status == 0 ? ganglion::kDone : ganglion::kBadInput;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_in_words);
  try {
    return carry_out(argc, argv);
  } catch (...) {
    return refuse_thrown();
  }
}
