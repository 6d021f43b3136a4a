#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion::link {

/// A robot's program that runs as long as this object: started with the port it shall listen on, told to end (SIGTERM,
/// and SIGKILL 2 s later) with everything it started itself. What it prints is kept in a file of its own.
class Program {
 public:
  /// "{port}" in an argument becomes the port; the environment has it as GANGLION_PORT as well. Relative programs and
  /// arguments are as seen from `folder`. What it prints goes beside `output`, under a name of its own that ends alike, so
  /// that no other program writes there too. Fails with NotFound or Unwritable.
  static Result<Program> start(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                               std::uint16_t port, const std::filesystem::path& output);
  Program(Program&& other) noexcept;
  Program& operator=(Program&&) = delete;
  ~Program();

  /// Whether it ended by itself.
  bool ended() noexcept;
  const std::filesystem::path& output() const noexcept { return output_; }
  /// Gives that file its name, in the place of an older one; where that cannot be it keeps its own.
  void name_output(const std::filesystem::path& name);
  /// The last three lines it printed, " | " between; or that it printed nothing.
  Sentence last_words() const;

 private:
  Program(pid_t process, std::filesystem::path output) : process_(process), output_(std::move(output)) {}
  pid_t process_;
  std::filesystem::path output_;
};

/// A TCP port of this machine that is free now. Fails with LinkLost.
Result<std::uint16_t> free_port();

}  // namespace ganglion::link
