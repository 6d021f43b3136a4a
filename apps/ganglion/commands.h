#pragma once

#include <CLI/CLI.hpp>

namespace ganglion {

/// Exit codes, the same for every subcommand.
enum ExitCode : int {
  kDone = 0,          ///< Done; of a single run: the robot succeeded, or nobody judged.
  kRobotFailed = 1,   ///< The run was carried out, the criterion of success was not met; or a replay differed.
  kBadInput = 2,      ///< A file or an option is wrong; what and where is on standard error.
  kLinkLostCode = 3,  ///< A robot elsewhere cannot be reached, or any more; or an address cannot be listened at.
  kOutputFailed = 4,  ///< Something could not be written.
};

/// Each adds its subcommand to the program; the callback leaves its exit code in `code`.
void add_run(CLI::App& program, int& code);
void add_sim(CLI::App& program, int& code);
void add_proxy(CLI::App& program, int& code);
void add_check(CLI::App& program, int& code);
void add_format(CLI::App& program, int& code);
void add_kinds(CLI::App& program, int& code);
void add_doctor(CLI::App& program, int& code);
void add_replay(CLI::App& program, int& code);
void add_plot(CLI::App& program, int& code);
void add_runs(CLI::App& program, int& code);
void add_experience(CLI::App& program, int& code);
void add_schema(CLI::App& program, int& code);
void add_studio(CLI::App& program, int& code);

}  // namespace ganglion
