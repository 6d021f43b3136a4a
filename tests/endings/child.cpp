#include "tests/endings/child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "ganglion/base/file.h"

namespace ganglion {

namespace fs = std::filesystem;

namespace {

void redirect(int descriptor, const fs::path& file) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (fd < 0 || ::dup2(fd, descriptor) < 0) ::_exit(126);
}

template <class Resource>
void limit(Resource resource, std::uint64_t bytes) {
  const rlimit most{bytes, bytes};
  if (bytes > 0 && ::setrlimit(resource, &most) != 0) ::_exit(126);
}

}  // namespace

Child::Child(const fs::path& folder, std::vector<std::string> words) : Child(folder, std::move(words), Limits()) {}

Child::Child(const fs::path& folder, std::vector<std::string> words, const Limits& limits) : folder_(folder) {
  words.insert(words.begin(), GANGLION_PROGRAM);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ != 0) return;
  redirect(STDOUT_FILENO, limits.output != nullptr ? fs::path(limits.output) : folder_ / "out");
  redirect(STDERR_FILENO, folder_ / "err");
  limit(RLIMIT_FSIZE, limits.file_bytes);
  limit(RLIMIT_AS, limits.memory_bytes);
  ::execv(arguments[0], arguments.data());
  ::_exit(127);
}

Child::~Child() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void Child::send(int signal) const { ::kill(pid_, signal); }

bool Child::running() {
  if (pid_ > 0 && ::waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = -1;
  return pid_ > 0;
}

fs::path being_written(const fs::path& file) {
  std::error_code error;
  fs::directory_iterator entry(file.parent_path(), error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path& one = entry->path();
    if (one.filename().string().starts_with(file.stem().string() + ".part-") && one.extension() == file.extension())
      return one;
  }
  return file;
}

bool Child::wait_for(const fs::path& file, std::uint64_t bytes) {
  while (true) {
    const bool alive = running();
    std::error_code missing;
    const auto size = fs::file_size(being_written(file), missing);
    if (!missing && size >= bytes) return true;
    if (!alive) return false;
    std::this_thread::yield();
  }
}

int Child::wait() {
  if (pid_ > 0 && ::waitpid(pid_, &status_, 0) == pid_) pid_ = -1;
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
}

std::string Child::out() const { return read_file(folder_ / "out").value_or(""); }
std::string Child::err() const { return read_file(folder_ / "err").value_or(""); }

}  // namespace ganglion
