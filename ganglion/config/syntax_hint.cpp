#include "ganglion/config/syntax_hint.h"

#include <array>

namespace ganglion::config {
namespace {

struct Hint {
  std::string_view parsing;  ///< What was being read, as the parser names it; "" = whatever.
  std::string_view complaint;
  Text words;
};

/// The first that fits counts.
constexpr std::array kHints = {
    Hint{"", "utf-8", {"the file must be saved as UTF-8", "el archivo debe guardarse como UTF-8"}},
    Hint{"string",
         "control characters",
         {"a text must be closed by its quote on the same line, and holds no control characters",
          "un texto debe cerrarse con su comilla en la misma línea, y no contiene caracteres de control"}},
    Hint{"string", "end-of-file", {"a text is not closed by its quotes", "un texto no está cerrado con sus comillas"}},
    Hint{"string",
         "escape sequence",
         {"a \\ starts an escape; write \\\\, or put the text in 'single quotes'",
          "una \\ inicia una secuencia de escape; escriba \\\\, o ponga el texto entre 'comillas simples'"}},
    Hint{"",
         "could not determine value type",
         {"this is no value; texts stand in quotes, \"like this\"",
          "esto no es un valor; los textos van entre comillas, \"así\""}},
    Hint{"key-value pair", "expected value", {"after = a value is missing", "después de = falta un valor"}},
    Hint{"key-value pair", "expected '='", {"after a key come = and a value", "después de una clave van = y un valor"}},
    Hint{"key-value pair",
         "saw ','",
         {"one value a line; decimals have a point, as in 0.5",
          "un valor por línea; los decimales llevan punto, como 0.5"}},
    Hint{"key-value pair",
         "expected a comment",
         {"after its value a line must end", "después de su valor la línea debe terminar"}},
    Hint{"table header",
         "expected",
         {"a header is written [name] or [[name]], alone on its line",
          "un encabezado se escribe [nombre] o [[nombre]], solo en su línea"}},
    Hint{"number", "leading zeroes", {"a number has no leading zeros", "un número no empieza con ceros"}},
    Hint{"number", "not representable", {"this number is too large", "este número es demasiado grande"}},
    Hint{"number",
         "expected",
         {"this is no number; write 12, 0.5 or 1e-3, without a unit",
          "esto no es un número; escriba 12, 0.5 o 1e-3, sin unidad"}},
    Hint{"boolean", "expected", {"write true or false, in small letters", "escriba true o false, en minúsculas"}},
    Hint{"array",
         "expected",
         {"the items of a list are separated by commas, and a ] closes it",
          "los elementos de una lista se separan con comas, y la cierra un ]"}},
    Hint{"inline table",
         "expected",
         {"{ x = 1, y = 2 } is closed on its line, its members separated by commas",
          "{ x = 1, y = 2 } se cierra en su línea, con sus elementos separados por comas"}},
    Hint{"root table",
         "expected",
         {"a line starts with a key, a [header] or a # comment",
          "una línea empieza con una clave, un [encabezado] o un # comentario"}},
};

bool is_number(std::string_view parsing) noexcept {
  return parsing.ends_with("integer") || parsing.ends_with("floating-point");
}

}  // namespace

Sentence syntax_hint(std::string_view description) {
  constexpr std::string_view kOpening = "Error while parsing ";
  std::string_view parsing, complaint = description;
  if (const auto colon = description.find(": "); description.starts_with(kOpening) && colon != std::string_view::npos) {
    parsing = description.substr(kOpening.size(), colon - kOpening.size());
    complaint = description.substr(colon + 2);
  }
  if (complaint.starts_with("cannot redefine existing")) {
    const auto open = complaint.find('\''), close = complaint.rfind('\'');
    if (open == close)
      return say({"this name was used above for something else", "este nombre ya se usó más arriba para otra cosa"});
    return say({"\"{}\" was given above; each key and each [table] stands once",
                "\"{}\" ya se dio más arriba; cada clave y cada [tabla] aparece una vez"},
               complaint.substr(open + 1, close - open - 1));
  }
  if (is_number(parsing)) parsing = "number";
  for (const Hint& hint : kHints) {
    const bool fits = hint.parsing.empty() || parsing.ends_with(hint.parsing);
    if (fits && complaint.find(hint.complaint) != std::string_view::npos) return say({"{}", "{}"}, hint.words);
  }
  return Sentence::quoted(std::string(complaint));
}

}  // namespace ganglion::config
