#include "ganglion/kinds/kinds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "ganglion/descriptor/kind_page.h"
#include "ganglion/descriptor/kinds_json.h"
#include "ganglion/graph/schema.h"

// What holds for every kind there is: a new one is covered at birth.
namespace ganglion {
namespace {

/// Keys that the reader of controllers or robots takes before a kind's parameters.
const std::set<std::string_view> kReserved = {"id", "kind", "in", "command", "tolerance", "preemption"};

template <class Check>
void for_each(Check check) {
  for (const Descriptor* kind : all_descriptors()) {
    SCOPED_TRACE(std::string(name_of(kind->component_class)) + " " + std::string(kind->name));
    check(*kind);
  }
}

TEST(EveryKind, HasANameOfItsOwn) {
  std::set<std::string_view> names;
  EXPECT_GT(all_descriptors().size(), 5u);
  for_each([&](const Descriptor& kind) {
    EXPECT_TRUE(!kind.name.empty() && kind.name.front() >= 'A' && kind.name.front() <= 'Z');
    EXPECT_TRUE(names.insert(kind.name).second);
    if (!kind.paper_name.empty()) {
      EXPECT_TRUE(names.insert(kind.paper_name).second);
    }
  });
}

TEST(EveryKind, SaysWhatItIsInBothLanguagesAndWhereItComesFrom) {
  for_each([](const Descriptor& kind) {
    const auto expect_both = [](const Text& text, std::string_view of) { EXPECT_FALSE(text.empty()) << of; };
    expect_both(kind.summary, "summary");
    EXPECT_FALSE(kind.source.empty());
    for (const PortDescriptor& port : kind.ports) expect_both(port.help, port.name);
    for (const ParameterDescriptor& parameter : kind.parameters) expect_both(parameter.help, parameter.name);
  });
}

TEST(EveryKind, NamesPortsAndParametersOnce) {
  for_each([](const Descriptor& kind) {
    std::set<std::string_view> ports, parameters = kReserved;
    for (const PortDescriptor& port : common_outputs(kind)) ports.insert(port.name);
    for (const PortDescriptor& port : kind.ports) EXPECT_TRUE(ports.insert(port.name).second) << port.name;
    for (const ParameterDescriptor& parameter : kind.parameters) {
      EXPECT_TRUE(parameters.insert(parameter.name).second) << parameter.name;
    }
  });
}

TEST(EveryKind, HasDefaultsWithinItsOwnLimits) {
  for_each([](const Descriptor& kind) {
    for (const ParameterDescriptor& parameter : kind.parameters) {
      EXPECT_LE(parameter.min, parameter.max) << parameter.name;
      const auto within = [&](double value) {
        return std::isfinite(value) && value >= parameter.min && value <= parameter.max;
      };
      if (parameter.type == ParameterType::Real || parameter.type == ParameterType::Integer) {
        EXPECT_TRUE(within(parameter.preset)) << parameter.name;
      }
      if (parameter.type == ParameterType::Integer) {
        EXPECT_EQ(parameter.preset, std::floor(parameter.preset)) << parameter.name;
      }
      if (parameter.type == ParameterType::Choice) {
        EXPECT_LT(parameter.preset, static_cast<double>(parameter.choices.size())) << parameter.name;
      }
      for (const double value : parameter.preset_reals) EXPECT_TRUE(within(value)) << parameter.name;
    }
  });
}

TEST(EveryKind, NamesEachOfItsValuesOrNone) {
  for_each([](const Descriptor& kind) {
    for (const PortDescriptor& port : kind.ports) {
      if (port.elements.empty() || port.size == 1) continue;
      EXPECT_EQ(port.size, static_cast<int>(port.elements.size())) << port.name;
    }
  });
}

TEST(EveryKind, IsInTheManualThePaletteAndTheSchema) {
  const auto palette = nlohmann::json::parse(kinds_json(all_descriptors()));
  EXPECT_EQ(palette.size(), all_descriptors().size());
  const std::string schema = controller_schema(controller_kinds());
  EXPECT_TRUE(nlohmann::json::accept(schema));
  for_each([&](const Descriptor& kind) {
    for (const Language language : {Language::English, Language::Spanish}) {
      const std::string page = kind_page(kind, language);
      EXPECT_TRUE(page.starts_with("# " + std::string(kind.name)));
      for (const ParameterDescriptor& parameter : kind.parameters) {
        EXPECT_NE(page.find("| `" + std::string(parameter.name) + "` |"), std::string::npos) << parameter.name;
      }
    }
    const bool drawn = kind.component_class < ComponentClass::Sensor;
    EXPECT_EQ(schema.find("\"" + std::string(kind.name) + "\"") != std::string::npos, drawn);
  });
}

}  // namespace
}  // namespace ganglion
