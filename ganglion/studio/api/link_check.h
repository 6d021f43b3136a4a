#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/base/sentence.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

/// A look at a robot that may take its time, on a thread of its own: what `ganglion doctor --robot` says. The robot is
/// not moved. A program is started for it, and ended.
class LinkCheck {
 public:
  struct Subject {
    std::string address;               ///< One that allowed_address() takes, or "" for a program.
    std::vector<std::string> program;  ///< A listed command.
    std::filesystem::path folder;      ///< Where it is started.
    std::optional<Description> file;
    int robots = 0;
  };
  /// `told` gets the state at each finding, by the test's own thread.
  LinkCheck(std::string id, Subject subject, Language language, std::function<void(Json)> told);
  /// Gives up, and waits for that.
  ~LinkCheck();
  LinkCheck(const LinkCheck&) = delete;
  LinkCheck& operator=(const LinkCheck&) = delete;

  /// docs/studio_api.md, LinkTest.
  Json state() const;
  bool over() const;

 private:
  void look();
  void look_at_program();
  void examine(const std::string& address, double reach_s, const std::function<bool()>& stop);
  void find(bool good, const Sentence& finding);
  void finish();

  const Subject subject_;
  const Language language_;
  const std::function<void(Json)> told_;
  mutable std::mutex mutex_;
  Json state_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;  ///< Last: it uses all of these.
};

}  // namespace ganglion::studio
