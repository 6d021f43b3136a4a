#include "ganglion/descriptor/kind_page.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include "ganglion/base/text.h"
#include "ganglion/descriptor/common_parameters.h"

namespace ganglion {
namespace {

constexpr std::array<Text, 11> kClasses = {{{"Sensation", "Sensación"},
                                            {"Sensing module", "Módulo de detección"},
                                            {"Global goal", "Objetivo global"},
                                            {"Acting module", "Módulo de actuación"},
                                            {"Coordinator", "Coordinador"},
                                            {"Simulated sensor", "Sensor simulado"},
                                            {"Simulated drive", "Tracción simulada"},
                                            {"Simulated plant", "Planta simulada"},
                                            {"Task", "Tarea"},
                                            {"Measure", "Medida"},
                                            {"Picture", "Imagen"}}};
constexpr std::array<Text, 11> kGroups = {{{"Sensations", "Sensaciones"},
                                           {"Sensing modules", "Módulos de detección"},
                                           {"Global goals", "Objetivos globales"},
                                           {"Acting modules", "Módulos de actuación"},
                                           {"Coordinators", "Coordinadores"},
                                           {"Simulated sensors", "Sensores simulados"},
                                           {"Simulated drives", "Tracciones simuladas"},
                                           {"Simulated plants", "Plantas simuladas"},
                                           {"Tasks", "Tareas"},
                                           {"Measures", "Medidas"},
                                           {"Pictures", "Imágenes"}}};
constexpr std::array<Text, 6> kRoles = {{{"request", "solicitud"},
                                         {"feedback", "retroalimentación"},
                                         {"candidate", "candidato"},
                                         {"appraisal", "evaluación"},
                                         {"command", "mando"},
                                         {"output", "salida"}}};
constexpr std::array<Text, 3> kTypes = {{{"real", "real"}, {"discrete", "discreto"}, {"circular", "circular"}}};

/// What a table's cell may hold.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

template <class Item>
std::string code_list(const Item& items) {
  std::string list;
  for (const auto& item : items) list += fmt::format("{}`{}`", list.empty() ? "" : ", ", item);
  return list;
}

/// "DynamicMapRouter (AmDmr)".
std::string title_of(const Descriptor& kind) {
  return kind.paper_name.empty() ? std::string(kind.name) : fmt::format("{} ({})", kind.name, kind.paper_name);
}

/// What a heading is called in a link to it: letters and digits in lower case, a hyphen for each space.
std::string anchor_of(std::string_view title) {
  std::string anchor;
  for (const unsigned char c : title) {
    if (std::isalnum(c)) anchor += static_cast<char>(std::tolower(c));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

/// One kind's page; its title is a heading of `level`, 1 where the page stands alone.
class Page {
 public:
  Page(const Descriptor& kind, Language language, int level = 1) : kind_(kind), language_(language), level_(level) {}

  std::string run() {
    out_ = fmt::format("{} {}\n\n{}. {}\n", std::string(level_, '#'), title_of(kind_),
                       word(kClasses[static_cast<std::size_t>(kind_.component_class)]), kind_.summary.in(language_));
    print_ports(true, {"Inputs", "Entradas"});
    print_ports(false, {"Outputs", "Salidas"});
    print_parameters();
    if (!kind_.rests_on.empty()) {
      out_ += fmt::format("\n{}: {}\n", word({"What it learns rests on", "Lo que aprende se apoya en"}),
                          code_list(kind_.rests_on));
    }
    if (!kind_.source.empty()) out_ += fmt::format("\n{}: {}\n", word({"Source", "Fuente"}), kind_.source);
    return std::move(out_);
  }

 private:
  std::string_view word(const Text& text) const noexcept { return text.in(language_); }
  std::string_view yes_or_no(bool yes) const noexcept { return yes ? word({"yes", "sí"}) : word({"no", "no"}); }

  void heading(const Text& title, const Text& columns, int count) {
    out_ += fmt::format("\n{} {}\n\n| {} |\n", std::string(level_ + 1, '#'), word(title), word(columns));
    for (int i = 0; i < count; ++i) out_ += "| --- ";
    out_ += "|\n";
  }

  std::string shape_of(const PortDescriptor& port) const {
    std::string shape = fmt::format("{}", port.size);
    if (!port.elements.empty()) shape = code_list(element_names(port));
    if (port.size == 0) shape = word({"as wired", "según conexión"});
    if (port.many) {
      shape += port.each_candidate ? word({", a wire for each candidate", ", una conexión por candidato"})
                                   : word({", many wires", ", varias conexiones"});
    }
    return shape;
  }

  void print_port(const PortDescriptor& port, bool input) {
    out_ += fmt::format("| `{}` | {}{} | {} | {} | {} |", port.name, word(kRoles[static_cast<std::size_t>(port.role)]),
                        port.standing ? word({", a set-point", ", una consigna"}) : "",
                        port.unit == "*" ? word({"any", "cualquiera"}) : cell(port.unit),
                        word(kTypes[static_cast<std::size_t>(port.type)]), shape_of(port));
    if (input) out_ += fmt::format(" {} |", yes_or_no(port.required));
    out_ += fmt::format(" {} |\n", cell(port.help.in(language_)));
  }

  void print_ports(bool inputs, const Text& title) {
    std::vector<const PortDescriptor*> ports;
    for (const PortDescriptor& port : kind_.ports) {
      if (is_input(kind_.component_class, port.role) == inputs) ports.push_back(&port);
    }
    if (!inputs) {
      for (const PortDescriptor& port : common_outputs(kind_)) ports.push_back(&port);
    }
    if (ports.empty()) return;
    if (inputs) {
      heading(title,
              {"port | role | unit | type | values | required | meaning",
               "puerto | función | unidad | tipo | valores | obligatorio | significado"},
              7);
    } else {
      heading(
          title,
          {"port | role | unit | type | values | meaning", "puerto | función | unidad | tipo | valores | significado"},
          6);
    }
    for (const PortDescriptor* port : ports) print_port(*port, inputs);
  }

  std::string range_of(const ParameterDescriptor& parameter) const {
    const bool low = std::isfinite(parameter.min), high = std::isfinite(parameter.max);
    switch (parameter.type) {
      case ParameterType::Boolean:
        return "`true`, `false`";
      case ParameterType::Choice:
        return code_list(parameter.choices);
      case ParameterType::Word:
        return std::string(word({"text", "texto"}));
      case ParameterType::File:
        return std::string(word({"file", "archivo"}));
      default:
        break;
    }
    std::string range;
    for (const double value : parameter.allowed) range += (range.empty() ? "" : ", ") + shortest(value);
    if (!range.empty()) return range;
    if (low && high) range = fmt::format("{} .. {}", shortest(parameter.min), shortest(parameter.max));
    if (low && !high) range = ">= " + shortest(parameter.min);
    if (!low && high) range = "<= " + shortest(parameter.max);
    if (parameter.type != ParameterType::Reals) return range;
    const auto count =
        parameter.count == 0 ? std::string(word({"any number", "cuantos se quiera"})) : std::to_string(parameter.count);
    return fmt::format("{}{}{}", count, range.empty() ? "" : ": ", range);
  }

  static std::string preset_of(const ParameterDescriptor& parameter) {
    const ParameterValue preset = parameter.preset();
    if (const auto* word = std::get_if<std::string>(&preset)) return fmt::format("`\"{}\"`", *word);
    if (const auto* file = std::get_if<FileText>(&preset)) return fmt::format("`\"{}\"`", file->name);
    if (const auto* numbers = std::get_if<std::vector<double>>(&preset)) {
      std::vector<std::string> values;
      for (const double value : *numbers) values.push_back(shortest(value));
      return "[" + join(values) + "]";
    }
    const double number = std::get<double>(preset);
    if (parameter.type == ParameterType::Boolean) return number != 0 ? "`true`" : "`false`";
    if (parameter.type != ParameterType::Choice) return shortest(number);
    return fmt::format("`{}`", parameter.choices[static_cast<std::size_t>(number)]);
  }

  void print_parameter(const ParameterDescriptor& parameter, std::string_view mark) {
    out_ += fmt::format("| `{}` | {} | {} | {} | {}: {}{} |\n", parameter.name, cell(parameter.unit),
                        cell(range_of(parameter)), cell(preset_of(parameter)), cell(word(parameter.title)),
                        cell(word(parameter.help)), mark);
  }

  void print_parameters() {
    const auto common = common_parameters(kind_.component_class);
    if (kind_.parameters.empty() && common.empty()) return;
    heading({"Parameters", "Parámetros"},
            {"parameter | unit | range | default | meaning", "parámetro | unidad | rango | por defecto | significado"},
            5);
    bool any_ours = false;
    for (const ParameterDescriptor& parameter : kind_.parameters) {
      print_parameter(parameter, parameter.ours ? word({" *Ours.*", " *Nuestro.*"}) : "");
      any_ours = any_ours || parameter.ours;
    }
    for (const ParameterDescriptor& parameter : common) {
      print_parameter(parameter, word({" *Of the class.*", " *De la clase.*"}));
    }
    if (!any_ours || level_ > 1) return;  // a page of many kinds says it once
    out_ += word({"\n*Ours*: the source gives no value; this one is our reconstruction.\n",
                  "\n*Nuestro*: la fuente no da el valor; este lo hemos reconstruido.\n"});
  }

  const Descriptor& kind_;
  Language language_;
  int level_;
  std::string out_;
};

constexpr Text kIntroduction = {
    R"(# ganglion kinds [KIND]

Lists every kind of component, or shows the page of one (its own name or the paper's: `DynamicMapRouter`, `AmDmr`).
`--language es` does so in Spanish, `--json` gives all of it as data with the texts in both languages, and `--markdown` prints
this page ([in Spanish](kinds.es.md)): it is written by the program from what each kind says of itself, and a test
compares the two.

*Ours* marks a value that the source does not give: a reconstruction, never the author's; *of the class* what every component
of its class takes. Other keys that all take, as `in.<port>` and `command`, stand in [controller.toml](controller_toml.md); those of sensors and
drives in [robot.toml](robot_toml.md). What `status` and `reason` say: [controller.toml](controller_toml.md#status-and-reason).
)",
    R"(# ganglion kinds [TIPO]

Enumera todos los tipos de componente, o muestra la página de uno (su nombre o el del artículo: `DynamicMapRouter`, `AmDmr`).
`--language es` lo hace en español, `--json` lo da todo como datos con los textos en ambos idiomas y `--markdown` imprime
esta página ([en inglés](kinds.md)): la escribe el programa a partir de lo que cada tipo dice de sí mismo, y una prueba
compara ambas cosas.

*Nuestro* señala un valor que la fuente no da: una reconstrucción, nunca del autor; *de la clase*, lo que admite todo componente
de su clase. Otras claves que todos admiten, como `in.<puerto>` y `command`, están en [controller.toml](controller_toml.md); las de sensores y
tracciones, en [robot.toml](robot_toml.md). Qué dicen `status` y `reason`: [controller.toml](controller_toml.md#status-and-reason).
)"};

/// Which kinds there are, each with a link to its part of the page.
std::string contents(std::span<const Descriptor* const> kinds, Language language) {
  std::string table =
      fmt::format("\n| {} |\n| --- | --- |\n", Text("kind | what it does", "tipo | qué hace").in(language));
  for (const Descriptor* kind : kinds) {
    const std::string title = title_of(*kind);
    table += fmt::format("| [{}](#{}) | {} |\n", title, anchor_of(title), cell(kind->summary.in(language)));
  }
  return table;
}

}  // namespace

std::string kind_page(const Descriptor& kind, Language language) { return Page(kind, language).run(); }

std::string kinds_page(std::span<const Descriptor* const> kinds, Language language) {
  std::string page = std::string(kIntroduction.in(language)) + contents(kinds, language);
  const Descriptor* before = nullptr;
  for (const Descriptor* kind : kinds) {
    if (!before || before->component_class != kind->component_class) {
      page += fmt::format("\n## {}\n", kGroups[static_cast<std::size_t>(kind->component_class)].in(language));
    }
    page += "\n" + Page(*kind, language, 3).run();
    before = kind;
  }
  return page;
}

}  // namespace ganglion
