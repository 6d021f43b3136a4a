#include <cstdio>
#include <new>

#include "commands.h"
#include "ganglion/run/version.h"
#include "interrupt.h"
#include "language.h"

int main(int argc, char** argv) {
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
  } catch (const std::bad_alloc&) {
    constexpr ganglion::Text kWords{"out of memory: take fewer robots, threads or seeds, or a smaller world\n",
                                    "no queda memoria: tome menos robots, hilos o semillas, o un mundo más pequeño\n"};
    const std::string_view words = kWords.in(ganglion::language());
    std::fwrite(words.data(), 1, words.size(), stderr);
    return ganglion::kBadInput;
  }
  return code;
}
