#include "ganglion/descriptor/kind_page.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

constexpr std::array<Text, 8> kClasses = {{{"Sensation", "Sensación"},
                                           {"Sensing module", "Módulo sensor"},
                                           {"Global goal", "Meta global"},
                                           {"Acting module", "Módulo actuador"},
                                           {"Coordinator", "Coordinador"},
                                           {"Simulated sensor", "Sensor simulado"},
                                           {"Simulated drive", "Tracción simulada"},
                                           {"Simulated plant", "Planta simulada"}}};
constexpr std::array<Text, 6> kRoles = {{{"request", "solicitud"},
                                         {"feedback", "realimentación"},
                                         {"candidate", "candidato"},
                                         {"appraisal", "previsión"},
                                         {"command", "orden"},
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

class Page {
 public:
  Page(const Descriptor& kind, Language language) : kind_(kind), language_(language) {}

  std::string run() {
    out_ = fmt::format("# {}{}\n\n{}. {}\n", kind_.name,
                       kind_.paper_name.empty() ? "" : fmt::format(" ({})", kind_.paper_name),
                       word(kClasses[static_cast<std::size_t>(kind_.component_class)]), in(language_, kind_.summary));
    print_ports(true, {"Inputs", "Entradas"});
    print_ports(false, {"Outputs", "Salidas"});
    print_parameters();
    if (!kind_.source.empty()) out_ += fmt::format("\n{}: {}\n", word({"Source", "Fuente"}), kind_.source);
    return std::move(out_);
  }

 private:
  std::string_view word(const Text& text) const noexcept { return in(language_, text); }
  std::string_view yes_or_no(bool yes) const noexcept { return yes ? word({"yes", "sí"}) : word({"no", "no"}); }

  void heading(const Text& title, const Text& columns, int count) {
    out_ += fmt::format("\n## {}\n\n| {} |\n", word(title), word(columns));
    for (int i = 0; i < count; ++i) out_ += "| --- ";
    out_ += "|\n";
  }

  std::string shape_of(const PortDescriptor& port) const {
    std::string shape = fmt::format("{}", port.size);
    if (!port.elements.empty()) shape = code_list(port.elements);
    if (port.size == 0) shape = word({"as wired", "según conexión"});
    if (port.many) shape += word({", many wires", ", varias conexiones"});
    return shape;
  }

  void print_port(const PortDescriptor& port, bool input) {
    out_ += fmt::format("| `{}` | {} | {} | {} | {} |", port.name, word(kRoles[static_cast<std::size_t>(port.role)]),
                        port.unit == "*" ? word({"any", "cualquiera"}) : cell(port.unit),
                        word(kTypes[static_cast<std::size_t>(port.type)]), shape_of(port));
    if (input) out_ += fmt::format(" {} |", yes_or_no(port.required));
    out_ += fmt::format(" {} |\n", cell(in(language_, port.help)));
  }

  void print_ports(bool inputs, const Text& title) {
    std::vector<const PortDescriptor*> ports;
    for (const PortDescriptor& port : kind_.ports) {
      if (is_input(kind_.component_class, port.role) == inputs) ports.push_back(&port);
    }
    if (!inputs) {
      for (const PortDescriptor& port : common_outputs(kind_.component_class)) ports.push_back(&port);
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
      default:
        break;
    }
    std::string range;
    if (low && high) range = fmt::format("{} .. {}", shortest(parameter.min), shortest(parameter.max));
    if (low && !high) range = ">= " + shortest(parameter.min);
    if (!low && high) range = "<= " + shortest(parameter.max);
    if (parameter.type != ParameterType::Reals) return range;
    const auto count =
        parameter.count == 0 ? std::string(word({"any number", "cuantos se quiera"})) : std::to_string(parameter.count);
    return fmt::format("{}{}{}", count, range.empty() ? "" : ": ", range);
  }

  std::string preset_of(const ParameterDescriptor& parameter) const {
    switch (parameter.type) {
      case ParameterType::Boolean:
        return parameter.preset != 0 ? "`true`" : "`false`";
      case ParameterType::Choice:
        return fmt::format("`{}`", parameter.choices[static_cast<std::size_t>(parameter.preset)]);
      case ParameterType::Word:
        return fmt::format("`\"{}\"`", parameter.preset_word);
      case ParameterType::Reals: {
        std::vector<std::string> values;
        for (const double value : parameter.preset_reals) values.push_back(shortest(value));
        return "[" + join(values) + "]";
      }
      default:
        return shortest(parameter.preset);
    }
  }

  void print_parameters() {
    if (kind_.parameters.empty()) return;
    heading({"Parameters", "Parámetros"},
            {"parameter | unit | range | default | meaning", "parámetro | unidad | rango | por defecto | significado"},
            5);
    for (const ParameterDescriptor& parameter : kind_.parameters) {
      out_ += fmt::format("| `{}` | {} | {} | {} | {}{} |\n", parameter.name, cell(parameter.unit),
                          cell(range_of(parameter)), cell(preset_of(parameter)), cell(in(language_, parameter.help)),
                          parameter.ours ? word({" *Ours.*", " *Nuestro.*"}) : "");
    }
    for (const ParameterDescriptor& parameter : kind_.parameters) {
      if (!parameter.ours) continue;
      out_ += word({"\n*Ours*: the source gives no value; this one is our reconstruction.\n",
                    "\n*Nuestro*: la fuente no da el valor; este lo hemos reconstruido.\n"});
      break;
    }
  }

  const Descriptor& kind_;
  Language language_;
  std::string out_;
};

}  // namespace

std::string kind_page(const Descriptor& kind, Language language) { return Page(kind, language).run(); }

}  // namespace ganglion
