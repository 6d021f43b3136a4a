#include "ganglion/studio/api/link_check.h"

#include <unistd.h>

#include "ganglion/base/denied.h"
#include "ganglion/base/text.h"
#include "ganglion/link/controller/examination.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/program.h"

namespace ganglion::studio {
namespace {

constexpr double kPatience_s = 3;
constexpr double kStart_s = 10;  // for a program to listen, as in a run
constexpr std::size_t kMostFindings = 200;
constexpr std::size_t kLongest = 4000;

}  // namespace

LinkCheck::LinkCheck(std::string id, Subject subject, Language language, std::function<void(Json)> told)
    : subject_(std::move(subject)),
      language_(language),
      told_(std::move(told)),
      state_({{"test", std::move(id)}, {"done", false}, {"good", true}, {"findings", Json::array()}}),
      thread_([this] { look(); }) {}

LinkCheck::~LinkCheck() {
  stop_ = true;
  thread_.join();
}

Json LinkCheck::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

bool LinkCheck::over() const {
  const std::lock_guard lock(mutex_);
  return state_["done"];
}

void LinkCheck::find(bool good, const Sentence& finding) {
  Json now;
  {
    const std::lock_guard lock(mutex_);
    if (!good) state_["good"] = false;
    if (state_["findings"].size() >= kMostFindings) return;
    state_["findings"].push_back({{"good", good}, {"message", printable(finding.in(language_), kLongest)}});
    now = state_;
  }
  told_(std::move(now));
}

void LinkCheck::finish() {
  Json now;
  {
    const std::lock_guard lock(mutex_);
    state_["done"] = true;
    now = state_;
  }
  told_(std::move(now));
}

void LinkCheck::examine(const std::string& text, double reach_s, const std::function<bool()>& stop) {
  const auto address = link::parse_address(text);
  if (!address) return find(false, address.error().what);
  link::ExaminationOptions options;
  options.reach_s = reach_s;
  options.patience_s = kPatience_s;
  options.file = subject_.file ? &*subject_.file : nullptr;
  options.robots = subject_.robots;
  options.stop = stop;
  const bool good = link::examine(
      link::make_line(*address), [this](bool fine, const Sentence& finding) { find(fine, finding); }, options);
  if (good) find(true, say({"a controller can drive it", "un controlador puede conducirlo"}));
}

void LinkCheck::look_at_program() {
  const auto port = link::free_port();
  if (!port) return find(false, port.error().what);
  static std::atomic<int> count = 0;
  const std::filesystem::path output =
      std::filesystem::temp_directory_path() / fmt::format("ganglion_test_{}_{}.log", ::getpid(), ++count);
  {
    auto program = link::Program::start(subject_.program, subject_.folder, *port, output);
    if (!program) return find(false, program.error().what);
    find(true, say({"the program was started: {}", "se inició el programa: {}"}, subject_.program.front()));
    examine(fmt::format("tcp://127.0.0.1:{}", *port), kStart_s, [&] { return stop_.load() || program->ended(); });
    if (!state()["good"]) {
      find(false, program->ended()
                      ? say({"the program ended and last said: {}", "el programa terminó y lo último que dijo es: {}"},
                            program->last_words())
                      : say({"the program runs and last said: {}", "el programa sigue y lo último que dijo es: {}"},
                            program->last_words()));
    }
  }
  std::error_code ignored;
  std::filesystem::remove(output, ignored);
  find(true, say({"the program was ended again", "se terminó el programa"}));
}

void LinkCheck::look() {
  try {
    if (subject_.program.empty()) {
      examine(subject_.address, 0, [this] { return stop_.load(); });
    } else {
      look_at_program();
    }
  } catch (...) {
    find(false, denied().what);
  }
  finish();
}

}  // namespace ganglion::studio
