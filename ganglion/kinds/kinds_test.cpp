#include "ganglion/kinds/kinds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "ganglion/descriptor/common_parameters.h"
#include "ganglion/descriptor/kind_page.h"
#include "ganglion/descriptor/kinds_json.h"
#include "ganglion/graph/schema.h"

// What holds for every kind there is: a new one is covered at birth.
namespace ganglion {
namespace {

/// Keys that the reader of controllers or robots takes before a kind's parameters.
const std::set<std::string_view> kReserved = {"id", "kind", "in", "command"};

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
    for (const PortDescriptor& port : kind.ports) {
      expect_both(port.title, port.name);
      expect_both(port.help, port.name);
    }
    for (const ParameterDescriptor& parameter : kind.parameters) {
      expect_both(parameter.title, parameter.name);
      expect_both(parameter.help, parameter.name);
    }
  });
}

TEST(EveryKind, NamesPortsAndParametersOnce) {
  for_each([](const Descriptor& kind) {
    std::set<std::string_view> ports, parameters = kReserved;
    for (const PortDescriptor& port : common_outputs(kind)) ports.insert(port.name);
    for (const ParameterDescriptor& parameter : common_parameters(kind.component_class)) {
      parameters.insert(parameter.name);
    }
    for (const PortDescriptor& port : kind.ports) EXPECT_TRUE(ports.insert(port.name).second) << port.name;
    for (const ParameterDescriptor& parameter : kind.parameters) {
      EXPECT_TRUE(parameters.insert(parameter.name).second) << parameter.name;
    }
  });
}

/// The numbers of a default; none of a word.
std::vector<double> numbers_of(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return {*number};
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  return numbers != nullptr ? *numbers : std::vector<double>{};
}

TEST(EveryKind, HasDefaultsWithinItsOwnLimits) {
  for_each([](const Descriptor& kind) {
    for (const ParameterDescriptor& parameter : kind.parameters) {
      SCOPED_TRACE(std::string(parameter.name));
      EXPECT_LE(parameter.min, parameter.max);
      for (const double value : numbers_of(parameter.preset())) {
        EXPECT_TRUE(std::isfinite(value));
        if (parameter.type == ParameterType::Choice) {
          EXPECT_LT(value, static_cast<double>(parameter.choices.size()));
          continue;
        }
        EXPECT_GE(value, parameter.min);
        EXPECT_LE(value, parameter.max);
        if (!parameter.allowed.empty()) {
          EXPECT_TRUE(std::find(parameter.allowed.begin(), parameter.allowed.end(), value) != parameter.allowed.end());
        }
      }
    }
  });
}

TEST(EveryKind, TiesItsParametersToOneConfig) {
  for_each([](const Descriptor& kind) {
    for (const ParameterDescriptor& parameter : kind.parameters) {
      EXPECT_NE(parameter.store, nullptr) << parameter.name;
      EXPECT_EQ(parameter.config, kind.parameters.front().config) << parameter.name;
    }
  });
}

TEST(EveryKind, RestsOnParametersThatItHas) {
  for_each([](const Descriptor& kind) {
    for (const std::string_view name : kind.rests_on) EXPECT_NE(kind.parameter(name), nullptr) << name;
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
