#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "ganglion/studio/api/ask.h"

namespace ganglion::studio {

/// Which command answers at which path. Each group of commands puts its own routes in.
class Router {
 public:
  using Answer = std::function<Reply(const Ask&)>;
  /// Each path once.
  void get(std::string path, Answer answer) { add(std::move(path), "GET", std::move(answer)); }
  /// The body must be a JSON object, or empty.
  void post(std::string path, Answer answer) { add(std::move(path), "POST", std::move(answer)); }

  /// Whatever is asked: what no route takes is a failure too.
  Reply handle(const Call& call) const;

 private:
  struct Route {
    std::string_view method;
    Answer answer;
  };
  void add(std::string path, std::string_view method, Answer answer);
  std::map<std::string, Route> routes_;
};

}  // namespace ganglion::studio
