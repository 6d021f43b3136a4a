#include "ganglion/graph/testing/pieces.h"

#include <fmt/format.h>

namespace ganglion::testing {

std::string sensations(std::initializer_list<std::string_view> channels) {
  std::string text;
  for (const std::string_view channel : channels) {
    text += fmt::format("[[sensation]]\nid = \"{0}\"\nchannel = \"{0}\"\n", channel);
  }
  return text;
}

std::string gain(std::string_view id, std::string_view in, double factor) {
  const std::string settings = factor == 1 ? "" : fmt::format("gain = {:.1f}\n", factor);
  return fmt::format("[[sensing]]\nid = \"{}\"\nkind = \"Gain\"\nin.in = \"{}\"\n{}", id, in, settings);
}

std::string wish(std::string_view id, std::string_view settings) {
  return fmt::format("[[goal]]\nid = \"{}\"\nkind = \"Wish\"\n{}\n", id, settings);
}

std::string seeker(std::string_view id, std::string_view goal, std::string_view settings) {
  return fmt::format("[[acting]]\nid = \"{}\"\nkind = \"Seeker\"\nin.goal = \"{}\"\nin.place = \"place\"\n{}\n", id,
                     goal, settings);
}

std::string puppet(std::string_view id, std::string_view act, std::string_view value, std::string_view settings) {
  return fmt::format("[[acting]]\nid = \"{}\"\nkind = \"Puppet\"\nin.act = \"{}\"\nin.value = \"{}\"\n{}\n", id, act,
                     value, settings);
}

std::string first(std::string_view id, std::string_view candidates, std::string_view settings) {
  return fmt::format("[[coordinator]]\nid = \"{}\"\nkind = \"First\"\nin.commands = [{}]\n{}\n", id, candidates,
                     settings);
}

}  // namespace ganglion::testing
