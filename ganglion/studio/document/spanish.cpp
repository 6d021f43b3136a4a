#include "ganglion/studio/document/spanish.h"

#include <array>

namespace ganglion::studio {
namespace {

constexpr auto kPhrases = std::to_array<Phrase>({
    // the ends of sentences
    {"; did you mean \"{}\"?", "; ¿quiso decir \"{0}\"?"},
    {"; valid: {}", "; válidos: {0}"},
    {"; it takes none", "; no tiene ninguna"},
    // whole files
    {"the file must start with format = 1", "el archivo debe empezar con format = 1"},
    {"this program reads format = 1; the file needs a newer program",
     "este programa lee format = 1; el archivo necesita un programa más nuevo"},
    {"format is {}, must be 1", "format es {0}, debe ser 1"},
    {"robot is missing: name the robot.toml it is drawn for",
     "falta robot: nombre el robot.toml para el que está dibujado"},
    {"robot lies outside of the folder that the studio was started for",
     "robot está fuera de la carpeta para la que se inició el estudio"},
    {"the robot cannot be read: line {}: {}", "no se puede leer el robot: línea {0}: {1}"},
    {"the robot this is drawn for is not known", "no se conoce el robot para el que está dibujado"},
    {"more than {} components", "más de {0} componentes"},
    {"not valid TOML: {}", "no es TOML válido: {0}"},
    {"the file must be saved as UTF-8", "el archivo debe guardarse como UTF-8"},
    {"a text must be closed by its quote on the same line, and holds no control characters",
     "un texto debe cerrarse con su comilla en la misma línea, y no contiene caracteres de control"},
    {"a text is not closed by its quotes", "un texto no está cerrado con sus comillas"},
    {"this is no value; texts stand in quotes, \"like this\"",
     "esto no es un valor; los textos van entre comillas, \"así\""},
    {"after = a value is missing", "después de = falta un valor"},
    {"after a key come = and a value", "después de una clave van = y un valor"},
    {"one value a line; decimals have a point, as in 0.5", "un valor por línea; los decimales llevan punto, como 0.5"},
    {"after its value a line must end", "después de su valor la línea debe terminar"},
    {"a header is written [name] or [[name]], alone on its line",
     "un encabezado se escribe [nombre] o [[nombre]], solo en su línea"},
    {"this is no number; write 12, 0.5 or 1e-3, without a unit",
     "esto no es un número; escriba 12, 0.5 o 1e-3, sin unidad"},
    {"the items of a list are separated by commas, and a ] closes it",
     "los elementos de una lista se separan con comas, y la cierra un ]"},
    {"a line starts with a key, a [header] or a # comment",
     "una línea empieza con una clave, un [encabezado] o un # comentario"},
    {"\"{}\" was given above; each key and each [table] stands once",
     "\"{0}\" ya se dio más arriba; cada clave y cada [tabla] aparece una vez"},
    // components
    {"id is missing; write id = \"a_name\"", "falta id; escriba id = \"un_nombre\""},
    {"\"{}\" is no id: write a letter, then letters, digits or _, at most 64 in all",
     "\"{0}\" no es un id: escriba una letra y después letras, cifras o _, 64 como máximo en total"},
    {"this id is already used at line {}", "este id ya se usa en la línea {0}"},
    {"\"{}\" is the id of another", "\"{0}\" es el id de otro componente"},
    {"kind is missing{}", "falta kind{0}"},
    {"\"{}\" is a kind of {}; write it under [[{}]], not [[{}]]",
     "\"{0}\" es un tipo de {1}; escríbalo en [[{2}]], no en [[{3}]]"},
    {"\"{}\" is no kind of {}; did you mean \"{}\"?", "\"{0}\" no es un tipo de {1}; ¿quiso decir \"{2}\"?"},
    {"\"{}\" is no kind of {}; valid: {}", "\"{0}\" no es un tipo de {1}; válidos: {2}"},
    {"\"{}\" is no kind of {}", "\"{0}\" no es un tipo de {1}"},
    {"acting module", "módulo de actuación"},
    {"sensing module", "módulo de detección"},
    {"coordinator", "coordinador"},
    {"sensation", "sensación"},
    {"goal", "objetivo global"},
    {"\"{}\" is no key here{}", "\"{0}\" no es una clave aquí{1}"},
    {"channel is empty; name a channel of the robot", "channel está vacío; nombre un canal del robot"},
    {"the robot has no channel \"{}\"{}", "el robot no tiene el canal \"{0}\"{1}"},
    {"the robot has a command of this name; choose another id",
     "el robot tiene una orden con este nombre; elija otro id"},
    {"tolerance is {}, but \"{}\" is made of whole numbers, which are compared exactly; leave it out",
     "tolerance es {0}, pero \"{1}\" se compone de números enteros, que se comparan con exactitud; quítela"},
    // inputs and wires
    {"input \"{}\" is not wired; write in.{} = \"...\"",
     "la entrada \"{0}\" no está conectada; escriba in.{1} = \"...\""},
    {"\"{}\" is an input; write in.{} = \"...\"", "\"{0}\" es una entrada; escriba in.{1} = \"...\""},
    {"{} has no input \"{}\"{}", "{0} no tiene la entrada \"{1}\"{2}"},
    {"input \"{}\" has {} wires; the limit is {}", "la entrada \"{0}\" tiene {1} cables; el límite es {2}"},
    {"input \"{}\" takes one wire, not {}", "la entrada \"{0}\" admite un cable, no {1}"},
    {"input \"{}\" takes what an acting module expects; \"{}\" is no appraisal",
     "la entrada \"{0}\" admite lo que espera un módulo de actuación; \"{1}\" no es una valoración"},
    {"input \"{}\" takes {} value{}, \"{}\" has {}{}",
     "la entrada \"{0}\" admite {1} valor(es){2}, \"{3}\" tiene {4}{5}"},
    {"input \"{}\" is in [{}], \"{}\" is in [{}]{}", "la entrada \"{0}\" está en [{1}], \"{2}\" está en [{3}]{4}"},
    {"\"{}\": the only mark is @previous, as in \"{}@previous\"",
     "\"{0}\": la única marca es @previous, como en \"{1}@previous\""},
    {"\"{}\" is no goal or acting module{}", "\"{0}\" no es un objetivo global ni un módulo de actuación{1}"},
    {"\"{}\" is no acting module or coordinator{}", "\"{0}\" no es un módulo de actuación ni un coordinador{1}"},
    {"\"{}\" is no sensation or module{}", "\"{0}\" no es una sensación ni un módulo{1}"},
    {"a request comes either from goals or from one module; \"{}\" is a module",
     "una petición viene de objetivos globales o de un solo módulo; \"{0}\" es un módulo"},
    {"a command is handed on within its tick; leave out @previous",
     "una orden se entrega dentro de su ciclo; quite @previous"},
    {"\"{}\" is a channel of the robot; wire the sensation that reads it: \"{}\"",
     "\"{0}\" es un canal del robot; conecte la sensación que lo lee: \"{1}\""},
    {"\"{}\" is a channel of the robot; add a [[sensation]] with channel = \"{}\" and wire its id",
     "\"{0}\" es un canal del robot; añada una [[sensation]] con channel = \"{1}\" y conecte su id"},
    {"\"{}\" is one value; write \"{}\", or \"{}.age_s\" for its age",
     "\"{0}\" es un solo valor; escriba \"{1}\", o \"{2}.age_s\" para su antigüedad"},
    {"sensation \"{}\" has no \"{}\"{}", "la sensación \"{0}\" no tiene \"{1}\"{2}"},
    {"\"{}\" has no outputs", "\"{0}\" no tiene salidas"},
    {"\"{}\" has several outputs; say which{}", "\"{0}\" tiene varias salidas; diga cuál{1}"},
    {"\"{}\" has no output \"{}\"{}", "\"{0}\" no tiene la salida \"{1}\"{2}"},
    {"\"{}\" has no \"{}\"{}", "\"{0}\" no tiene \"{1}\"{2}"},
    {"command \"{}\" has no \"{}\"{}", "la orden \"{0}\" no tiene \"{1}\"{2}"},
    {"the command of this tick is not made yet; write \"{}@previous\"",
     "la orden de este ciclo aún no está hecha; escriba \"{0}@previous\""},
    {"\"{}\" is known only later in the tick; write \"{}@previous\"",
     "\"{0}\" solo se conoce más tarde en el ciclo; escriba \"{1}@previous\""},
    {"these wires run in a circle within one tick: {}; write \"{}@previous\" to break it",
     "estos cables forman un círculo dentro de un ciclo: {0}; escriba \"{1}@previous\" para romperlo"},
    {"these wires run in a circle within one tick: {}; commands cannot; take one of these wires out",
     "estos cables forman un círculo dentro de un ciclo: {0}; las órdenes no pueden; quite uno de estos cables"},
    {"\"{}\" is wired to it already", "\"{0}\" ya está conectado a ella"},
    {"there is no input \"{}\" of a component \"{}\"", "no existe la entrada \"{0}\" de un componente \"{1}\""},
    // commands
    {"\"{}\" already asks \"{}\"", "\"{0}\" ya pide a \"{1}\""},
    {"the command of \"{}\" already goes to \"{}\"", "la orden de \"{0}\" ya va a \"{1}\""},
    {"the robot has no command \"{}\"{}", "el robot no tiene la orden \"{0}\"{1}"},
    {"its command goes to \"{}\" already; leave out command = \"{}\"",
     "su orden ya va a \"{0}\"; quite command = \"{1}\""},
    {"\"{}\" already commands \"{}\"; join them by a coordinator",
     "\"{0}\" ya manda \"{1}\"; únalos con un coordinador"},
    {"its command goes nowhere; write command = \"...\" (the robot has: {}) or wire it to a coordinator",
     "su orden no va a ninguna parte; escriba command = \"...\" (el robot tiene: {0}) o conéctela a un coordinador"},
    {"commands {} but \"{}\" takes {}", "manda {0} pero \"{1}\" admite {2}"},
    {"commands {} value{}, but requests to \"{}\" have {}",
     "manda {0} valor(es), pero las peticiones a \"{2}\" tienen {3}"},
    {"commands {} value{}, but \"{}\" has {}", "manda {0} valor(es), pero \"{2}\" tiene {3}"},
    {"commands {} value{}, but \"{}\" takes {}", "manda {0} valor(es), pero \"{2}\" admite {3}"},
    // operations of the studio
    {"there is no component \"{}\"{}", "no hay ningún componente \"{0}\"{1}"},
    {"there is no operation \"{}\"{}", "no hay ninguna operación \"{0}\"{1}"},
    {"this drawing is too large to try every wire at once; ask for this one alone",
     "este dibujo es demasiado grande para probar todos los cables a la vez; pregunte solo por este"},
    {"that is too much at once for a text so long", "es demasiado a la vez para un texto tan largo"},
    {"\"{}\" is no file of this folder", "\"{0}\" no es un archivo de esta carpeta"},
    {"\"{}\" cannot be set so", "\"{0}\" no se puede fijar así"},
    {"\"{}\" is not set", "\"{0}\" no está fijado"},
    {"input \"{}\" is not wired", "la entrada \"{0}\" no está conectada"},
    {"no wire comes from \"{}\" to input \"{}\"", "ningún cable va de \"{0}\" a la entrada \"{1}\""},
    {"the pasted text holds no component", "el texto pegado no contiene ningún componente"},
});

/// Values; the most general sentences.
constexpr auto kGeneral = std::to_array<Phrase>({
    {"a number", "un número"},
    {"a whole number", "un número entero"},
    {"true or false", "true o false"},
    {"a text in quotes", "un texto entre comillas"},
    {"a text", "un texto"},
    {"a list", "una lista"},
    {"a table", "una tabla"},
    {"a list of numbers", "una lista de números"},
    {"a list of {} numbers", "una lista de {0} números"},
    {"a text or a list of texts", "un texto o una lista de textos"},
    {"a list of texts only", "una lista de textos solamente"},
    {"one of {}", "uno de {0}"},
    {"written as {}", "escrito como {0}"},
    {"in {}", "estar en {0}"},
    {"{}: there is no file \"{}\"", "{0}: no existe el archivo \"{1}\""},
    {"{} has {} number{}, must have {}", "{0} tiene {1} número(s), debe tener {3}"},
    {"{} is {}, must be {}", "{0} es {1}, debe ser {2}"},
    {"{} is missing", "falta {0}"},
    {"{} is \"{}\"{}", "{0} es \"{1}\"{2}"},
});

}  // namespace

const std::vector<Phrase>& spanish_phrases() {
  static const std::vector<Phrase> all = [] {
    std::vector<Phrase> phrases(kPhrases.begin(), kPhrases.end());
    const auto add = [&](std::span<const Phrase> more) { phrases.insert(phrases.end(), more.begin(), more.end()); };
    add(spanish_of_files());
    add(spanish_of_links());
    add(kGeneral);
    return phrases;
  }();
  return all;
}

}  // namespace ganglion::studio
