#include "ganglion/graph/testing/ruled.h"

#include <array>

#include "ganglion/base/text.h"
#include "ganglion/graph/testing/described.h"

namespace ganglion::testing {
namespace {

struct RuledConfig {
  FileText rules{"builtin:twice.txt", "out 2\n", ""};
};

constexpr std::array kPorts = {port("in", PortRole::Feedback, "*")};
constexpr std::array kParameters = {named<RuledConfig, &RuledConfig::rules>("rules")};

struct Rule {
  std::string name;
  double factor = 0;
};

Result<std::vector<Rule>> rules_of(const FileText& file) {
  std::vector<Rule> rules;
  int line = 0;
  for (const std::string& text : split(file.text, '\n')) {
    ++line;
    if (text.empty()) continue;
    const std::size_t blank = std::min(text.find(' '), text.size() - 1);
    const auto factor = parse_number(text.substr(blank + 1));
    if (!factor)
      return fail_at(file.at(line, static_cast<int>(blank) + 2), ErrorCode::Syntax, {"no number", "no es un número"});
    rules.push_back({text.substr(0, blank), *factor});
  }
  return rules;
}

class Ruled final : public SensingModule {
 public:
  explicit Ruled(std::vector<Rule> rules) : rules_(std::move(rules)) {}
  static Result<std::unique_ptr<SensingModule>> make(const Parameters& parameters) {
    auto rules = rules_of(parameters.file("rules"));
    if (!rules) return tl::unexpected<Error>(rules.error());
    return std::make_unique<Ruled>(std::move(*rules));
  }
  static Result<Ports> shape(const Parameters& parameters) {
    const auto rules = rules_of(parameters.file("rules"));
    if (!rules) return tl::unexpected<Error>(rules.error());
    Ports ports;
    ports.add(kPorts[0]);
    for (const Rule& rule : *rules) {
      PortDescriptor out = port("", PortRole::Output);
      out.name = ports.own(rule.name);
      ports.add(out);
    }
    return ports;
  }

 private:
  void perceive(const Feedback& feedback) noexcept override {
    for (std::size_t i = 0; i < rules_.size(); ++i) put(i, rules_[i].factor * feedback.value(0));
  }
  std::vector<Rule> rules_;
};

}  // namespace

constinit const SensingModuleKind ruled_kind{
    {.component_class = ComponentClass::Sensing, .name = "Ruled", .ports = kPorts, .parameters = kParameters},
    Ruled::make,
    Ruled::shape};

}  // namespace ganglion::testing
