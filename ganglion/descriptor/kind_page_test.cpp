#include "ganglion/descriptor/kind_page.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "ganglion/descriptor/common_parameters.h"
#include "ganglion/descriptor/json_schema.h"
#include "ganglion/descriptor/kinds_json.h"

namespace ganglion {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<ElementDescriptor, 2> kTracks = {"left", "right"};
constexpr std::array<std::string_view, 2> kSides = {"left", "freer"};
constexpr std::array<double, 2> kTurns = {45, 90};

struct Config {
  double trigger_range_m = 0.1;
  int bursts = 3;
  bool loud = true;
  enum class Side { Left, Freer } side = Side::Freer;
  std::string label = "a";
  std::vector<double> gains = {1, 0.5};
  int turn_deg = 90;
};

constexpr std::array kPorts = {PortDescriptor{.name = "ahead",
                                              .title = {"range ahead", "distancia al frente"},
                                              .help = {"Range ahead", "Distancia al frente"},
                                              .unit = "m"},
                               PortDescriptor{.name = "others",
                                              .title = {"others", "otros"},
                                              .help = {"", ""},
                                              .unit = "*",
                                              .size = 0,
                                              .required = false,
                                              .many = true},
                               PortDescriptor{.name = "drive",
                                              .title = {"drive", "tracción"},
                                              .help = {"", ""},
                                              .role = PortRole::Command,
                                              .elements = kTracks}};
constexpr std::array kParameters = {
    parameter<Config, &Config::trigger_range_m>({.name = "trigger_range_m",
                                                 .title = {"trigger range", "distancia de disparo"},
                                                 .help = {"Acts nearer than this | at once", "Actúa más cerca"},
                                                 .unit = "m",
                                                 .min = 0,
                                                 .max = 3,
                                                 .ours = true,
                                                 .live = true}),
    parameter<Config, &Config::bursts>(
        {.name = "bursts", .title = {"bursts", "ráfagas"}, .help = {"How many", "Cuántas"}, .min = 1}),
    parameter<Config, &Config::loud>(
        {.name = "loud", .title = {"loud", "ruidoso"}, .help = {"Whether it is heard", "Si se oye"}}),
    parameter<Config, &Config::side>(
        {.name = "side", .title = {"side", "lado"}, .help = {"Where to", "Hacia dónde"}, .choices = kSides}),
    parameter<Config, &Config::label>(
        {.name = "label", .title = {"label", "etiqueta"}, .help = {"What it says", "Lo que dice"}}),
    parameter<Config, &Config::gains>({.name = "gains",
                                       .title = {"gains", "ganancias"},
                                       .help = {"Of each side", "De cada lado"},
                                       .max = 9,
                                       .count = 2}),
    parameter<Config, &Config::turn_deg>({.name = "turn_deg",
                                          .title = {"turn", "giro"},
                                          .help = {"How far", "Cuánto"},
                                          .unit = "deg",
                                          .allowed = kTurns})};
constexpr Descriptor kKind = {.name = "BackOff",
                              .paper_name = "AmBk",
                              .summary = {"Backs off from what is near", "Retrocede ante lo cercano"},
                              .ports = kPorts,
                              .parameters = kParameters,
                              .source = "A paper, section 2"};

TEST(KindPage, ShowsPortsAndParametersInEnglish) {
  const std::string page = kind_page(kKind, Language::English);
  EXPECT_TRUE(page.starts_with("# BackOff (AmBk)\n\nActing module. Backs off from what is near\n")) << page;
  for (const char* line : {
           "| port | role | unit | type | values | required | meaning |\n| --- | --- | --- | --- | --- | --- | --- |\n",
           "| `ahead` | feedback | m | real | 1 | yes | Range ahead |\n",
           "| `others` | feedback | any | real | as wired, many wires | no |  |\n",
           "| `drive` | command |  | real | `left`, `right` |  |\n",
           "| `active` | output |  | discrete | 1 | 1 while the module commands",
           "| `trigger_range_m` | m | 0 .. 3 | 0.1 | trigger range: Acts nearer than this \\| at once *Ours.* |\n",
           "| `bursts` |  | >= 1 | 3 | bursts: How many |\n",
           "| `loud` |  | `true`, `false` | `true` | loud: Whether it is heard |\n",
           "| `side` |  | `left`, `freer` | `freer` | side: Where to |\n",
           "| `label` |  | text | `\"a\"` | label: What it says |\n",
           "| `gains` |  | 2: <= 9 | [1, 0.5] | gains: Of each side |\n",
           "| `turn_deg` | deg | 45, 90 | 90 | turn: How far |\n",
           "| `preemption` |  | `true`, `false` | `true` | pre-emption: Whether a goal of a higher class may take the "
           "module "
           "over *Of the class.* |\n",
           "\n*Ours*: the source gives no value",
           "\nSource: A paper, section 2\n",
       }) {
    EXPECT_NE(page.find(line), std::string::npos) << line << "is not in\n" << page;
  }
}

TEST(KindPage, SpeaksSpanish) {
  const std::string page = kind_page(kKind, Language::Spanish);
  for (const char* line :
       {"Módulo de actuación. Retrocede ante lo cercano\n", "## Entradas\n", "## Salidas\n", "## Parámetros\n",
        "| `ahead` | retroalimentación | m | real | 1 | sí | Distancia al frente |\n",
        "| `trigger_range_m` | m | 0 .. 3 | 0.1 | distancia de disparo: Actúa más cerca *Nuestro.* |\n",
        "Fuente: A paper, section 2\n"}) {
    EXPECT_NE(page.find(line), std::string::npos) << line << "is not in\n" << page;
  }
}

TEST(KindsPage, ListsKindsWithLinksAndHoldsTheirPagesByClass) {
  Descriptor other = kKind;
  other.component_class = ComponentClass::Sensing;
  other.name = "Blur";
  other.paper_name = "";
  const std::array<const Descriptor*, 2> kinds = {&other, &kKind};
  const std::string page = kinds_page(kinds, Language::English);
  std::size_t at = 0;  // in this order
  for (const char* line :
       {"# ganglion kinds [KIND]\n", "| [Blur](#blur) | Backs off from what is near |\n",
        "| [BackOff (AmBk)](#backoff-ambk) |", "\n## Sensing modules\n\n### Blur\n\nSensing module. Backs off",
        "\n#### Inputs\n", "\n#### Parameters\n", "\n## Acting modules\n\n### BackOff (AmBk)\n",
        "\nSource: A paper, section 2\n"}) {
    const std::size_t found = page.find(line, at);
    ASSERT_NE(found, std::string::npos) << line << "is not in the rest of\n" << page;
    at = found;
  }
  EXPECT_NE(kinds_page(kinds, Language::Spanish).find("\n## Módulos de detección\n"), std::string::npos);
}

TEST(KindsJson, HoldsWhatPaletteAndFormsNeed) {
  const std::array<const Descriptor*, 1> kinds = {&kKind};
  const Json list = Json::parse(kinds_json(kinds));
  ASSERT_EQ(list.size(), 1u);
  const Json& kind = list[0];
  EXPECT_EQ(kind["class"], "acting");
  EXPECT_EQ(kind["name"], "BackOff");
  EXPECT_EQ(kind["paper_name"], "AmBk");
  EXPECT_EQ(kind["summary"]["es"], "Retrocede ante lo cercano");
  ASSERT_EQ(kind["ports"].size(), 3 + common_outputs(ComponentClass::Acting, {}).size());
  EXPECT_EQ(kind["ports"][0], Json::parse(R"({"name": "ahead", "direction": "in", "role": "feedback", "unit": "m",
      "type": "real", "size": 1, "elements": [], "required": true, "many": false, "common": false,
      "title": {"en": "range ahead", "es": "distancia al frente"},
      "help": {"en": "Range ahead", "es": "Distancia al frente"}})"));
  EXPECT_EQ(kind["ports"][2]["elements"], Json::parse(R"(["left", "right"])"));
  EXPECT_EQ(kind["ports"][2]["size"], 2);
  EXPECT_EQ(kind["ports"][2]["direction"], "out");
  EXPECT_EQ(kind["ports"][3]["name"], "active");
  EXPECT_EQ(kind["ports"][3]["common"], true);
  ASSERT_EQ(kind["parameters"].size(), 7 + common_parameters(ComponentClass::Acting).size());
  EXPECT_EQ(kind["parameters"][0], Json::parse(R"({"name": "trigger_range_m", "type": "real", "unit": "m",
      "default": 0.1, "min": 0.0, "max": 3.0, "ours": true, "live": true, "common": false,
      "title": {"en": "trigger range", "es": "distancia de disparo"},
      "help": {"en": "Acts nearer than this | at once", "es": "Actúa más cerca"}})"));
  EXPECT_FALSE(kind["parameters"][1].contains("max"));
  EXPECT_EQ(kind["parameters"][3]["default"], "freer");
  EXPECT_EQ(kind["parameters"][5]["max"], 9);
  EXPECT_EQ(kind["parameters"][5]["count"], 2);
  EXPECT_EQ(kind["parameters"][6]["allowed"], Json::parse("[45.0, 90.0]"));
  EXPECT_EQ(kind["parameters"][7]["name"], "tolerance");
  EXPECT_EQ(kind["parameters"][7]["common"], true);
}

TEST(ParameterSchema, SaysTypeLimitsAndDefault) {
  const auto schema = [](int index) { return parameter_schema(kParameters[static_cast<std::size_t>(index)]); };
  EXPECT_EQ(schema(0), Json::parse(R"({"type": "number", "minimum": 0.0, "maximum": 3.0, "default": 0.1,
      "description": "Acts nearer than this | at once [m] Ours: not given by the source."})"));
  EXPECT_EQ(schema(1).dump(), R"({"type":"integer","minimum":1,"default":3,"description":"How many"})");
  EXPECT_EQ(schema(2)["default"], true);
  EXPECT_EQ(schema(3)["enum"], Json::parse(R"(["left", "freer"])"));
  EXPECT_EQ(schema(4)["type"], "string");
  EXPECT_EQ(schema(5)["items"]["maximum"], 9);
  EXPECT_EQ(schema(5)["minItems"], 2);
  EXPECT_EQ(schema(6).dump(), R"({"type":"integer","enum":[45,90],"default":90,"description":"How far [deg]"})");
}

TEST(KindSchema, TakesBothNamesAndNoUnknownKey) {
  const Json schema = kind_schema(kKind);
  EXPECT_EQ(schema["properties"]["kind"]["enum"], Json::parse(R"(["BackOff", "AmBk"])"));
  EXPECT_EQ(schema["required"], Json::parse(R"(["kind"])"));
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(schema["properties"].size(), 8 + common_parameters(ComponentClass::Acting).size());
}

}  // namespace
}  // namespace ganglion
