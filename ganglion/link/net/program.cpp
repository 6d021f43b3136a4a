#include "ganglion/link/net/program.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include "ganglion/base/expects.h"
#include "ganglion/base/file.h"
#include "ganglion/base/new_file.h"
#include "ganglion/base/text.h"
#include "ganglion/link/net/lines.h"

namespace ganglion::link {
namespace {

constexpr double kPatience_s = 2;
constexpr std::ptrdiff_t kLastLines = 3;
constexpr useconds_t kLook_us = 5000;

std::string with_port(std::string text, const std::string& port) {
  for (std::size_t at = 0; (at = text.find("{port}", at)) != std::string::npos; at += port.size()) {
    text.replace(at, 6, port);
  }
  return text;
}

/// As exec wants them: a null at the end.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// What the child does between fork and exec: only what is safe there. Tells errno through the pipe.
[[noreturn]] void become(const std::vector<char*>& arguments, const std::vector<char*>& environment, const char* folder,
                         int output, int report) {
  ::setpgid(0, 0);            // so that whatever it starts ends with it
  ::signal(SIGINT, SIG_IGN);  // ctrl-C is for the controller, which ends the program in order
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  if (::chdir(folder) == 0) ::execvpe(arguments[0], arguments.data(), environment.data());
  const int error = errno;
  const ssize_t ignored = ::write(report, &error, sizeof error);
  ::_exit(ignored > 0 ? 127 : 126);
}

/// The errno with which the child could not become the program; 0: it did.
int failure_of(int report) {
  int error = 0;
  const ssize_t got = ::read(report, &error, sizeof error);
  return got == static_cast<ssize_t>(sizeof error) ? error : 0;
}

}  // namespace

Result<Program> Program::start(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                               std::uint16_t port, const std::filesystem::path& output) {
  expects(!arguments.empty());
  auto log = NewFile::beside(output, output.extension().string());
  if (!log) return tl::unexpected<Error>(log.error());
  log->keep();
  const std::string number = std::to_string(port);
  std::vector<std::string> texts;
  for (const std::string& argument : arguments) texts.push_back(with_port(argument, number));
  const std::vector<char*> pointers = pointers_to(texts);
  std::vector<std::string> variables = {"GANGLION_PORT=" + number};
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (!std::string_view(*variable).starts_with("GANGLION_PORT=")) variables.emplace_back(*variable);
  }
  const std::vector<char*> environment = pointers_to(variables);
  int report[2] = {-1, -1};
  const bool piped = ::pipe2(report, O_CLOEXEC) == 0;
  const std::string where = folder.empty() ? "." : folder.string();
  const pid_t process = piped ? ::fork() : -1;
  if (process == 0) become(pointers, environment, where.c_str(), log->descriptor(), report[1]);
  if (piped) ::close(report[1]);
  const int error = process < 0 ? errno : failure_of(report[0]);
  if (piped) ::close(report[0]);
  if (error == 0) return Program(process, log->path());
  if (process > 0) ::waitpid(process, nullptr, 0);
  return fail(
      ErrorCode::NotFound,
      {"application.program: \"{}\" cannot be started: {}", "application.program: no se puede iniciar \"{}\": {}"},
      texts.front(), std::generic_category().message(error));
}

Program::Program(Program&& other) noexcept
    : process_(std::exchange(other.process_, -1)), output_(std::move(other.output_)) {}

Program::~Program() {
  if (process_ <= 0) return;
  ::kill(-process_, SIGTERM);
  const double until_s = steady_s() + kPatience_s;
  while (!ended() && steady_s() < until_s) ::usleep(kLook_us);
  if (ended()) return;
  ::kill(-process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Program::name_output(const std::filesystem::path& name) {
  std::error_code failed;
  std::filesystem::rename(output_, name, failed);
  if (!failed) output_ = name;
}

bool Program::ended() noexcept {
  if (process_ > 0 && ::waitpid(process_, nullptr, WNOHANG) != 0) process_ = -1;
  return process_ <= 0;
}

Sentence Program::last_words() const {
  const auto text = read_file(output_);
  if (!text || trimmed(*text).empty()) return say({"nothing", "nada"});
  std::vector<std::string> lines = split(trimmed(*text), '\n');
  if (std::ssize(lines) > kLastLines) lines.erase(lines.begin(), lines.end() - kLastLines);
  return Sentence::quoted(printable(join(lines, " | "), 1000));
}

Result<std::uint16_t> free_port() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* plain = reinterpret_cast<sockaddr*>(&address);
  const bool bound = socket >= 0 && ::bind(socket, plain, size) == 0 && ::getsockname(socket, plain, &size) == 0;
  if (socket >= 0) ::close(socket);
  if (!bound) return fail(ErrorCode::LinkLost, {"no TCP port is free", "no hay ningún puerto TCP libre"});
  return ntohs(address.sin_port);
}

}  // namespace ganglion::link
