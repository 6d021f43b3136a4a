#pragma once

#include <array>
#include <string_view>

#include "ganglion/plot/view/language.h"

namespace ganglion::report {

/// A word of the page in both languages. An entry without its Spanish does not compile.
struct Entry {
  plot::Word key;
  plot::Word english;
  plot::Word spanish;
};

/// Every word of the reports, in the terms of the papers; the player in the page takes its words from here too.
inline constexpr std::array kEntries{
    Entry{"run", "Run", "Ejecución"},
    Entry{"seed", "seed", "semilla"},
    Entry{"duration", "duration", "duración"},
    Entry{"robots", "robots", "robots"},
    Entry{"digest", "digest", "huella"},
    Entry{"succeeded", "Succeeded", "Logrado"},
    Entry{"failed", "Failed", "No logrado"},
    Entry{"not_judged", "Not judged: the experiment has no criterion of success",
          "Sin juzgar: el experimento no tiene criterio de éxito"},
    Entry{"was_cut", "Cut short: no outcome was recorded", "Interrumpida: no se registró ningún resultado"},
    Entry{"criterion", "Criterion of success", "Criterio de éxito"},
    Entry{"other_language", "Español", "English"},
    Entry{"watch", "Watch the run", "Ver la ejecución"},
    Entry{"needs_script", "The player needs JavaScript; the pictures below do not.",
          "El reproductor necesita JavaScript; las imágenes de abajo no."},
    Entry{"stage", "The world seen from above, with the robots at the time shown",
          "El mundo visto desde arriba, con los robots en el instante mostrado"},
    Entry{"bands", "Behaviours over time; a click goes to that time",
          "Comportamientos en el tiempo; un clic lleva a ese instante"},
    Entry{"play", "Play", "Reproducir"},
    Entry{"pause", "Pause", "Pausar"},
    Entry{"back", "One tick back", "Un paso atrás"},
    Entry{"forth", "One tick on", "Un paso adelante"},
    Entry{"nearer", "Zoom in", "Acercar"},
    Entry{"farther", "Zoom out", "Alejar"},
    Entry{"time", "Time", "Tiempo"},
    Entry{"speed", "Speed", "Velocidad"},
    Entry{"robot", "Robot", "Robot"},
    Entry{"layers", "What is shown", "Qué se muestra"},
    Entry{"trail", "trail", "rastro"},
    Entry{"sonar", "sensor cones", "conos de los sensores"},
    Entry{"movers", "dynamic obstacles", "obstáculos dinámicos"},
    Entry{"field", "field", "campo"},
    Entry{"field_off", "hidden", "oculto"},
    Entry{"drives", "drives:", "conduce:"},
    Entry{"no_behaviour", "no behaviour", "ningún comportamiento"},
    Entry{"no_reading", "no valid reading", "sin lectura válida"},
    Entry{"nothing_in_range", "nothing in range", "nada al alcance"},
    Entry{"too_close", "too close", "demasiado cerca"},
    Entry{"legend", "Legend", "Leyenda"},
    Entry{"start", "start", "inicio"},
    Entry{"body", "robot, nose forward", "robot, con el morro hacia delante"},
    Entry{"touching", "robot in contact", "robot en contacto"},
    Entry{"wall", "wall", "pared"},
    Entry{"static_obstacle", "static obstacle", "obstáculo estático"},
    Entry{"dynamic_obstacle", "dynamic obstacle", "obstáculo dinámico"},
    Entry{"floor_zone", "other floor", "otro suelo"},
    Entry{"bump", "bump, unseen by sonar", "resalto, el sonar no lo ve"},
    Entry{"beacon", "beacon", "baliza"},
    Entry{"cone", "sensor cone, up to the reading", "cono del sensor, hasta la lectura"},
    Entry{"cone_empty", "sensor cone, nothing in range", "cono del sensor, nada al alcance"},
    Entry{"suppressed", "band: wants to, suppressed", "banda: quiere, suprimido"},
    Entry{"keys", "Keys", "Teclas"},
    Entry{"key_space", "Space", "Espacio"},
    Entry{"key_play", "play or pause", "reproducir o pausar"},
    Entry{"key_step", "a tick back, on", "un paso atrás, adelante"},
    Entry{"key_second", "a second back, on (with Shift: ten)", "un segundo atrás, adelante (con Mayús: diez)"},
    Entry{"key_zoom", "Ctrl + wheel: zoom", "Ctrl + rueda: acercar o alejar"},
    Entry{"measures", "Measures", "Medidas"},
    Entry{"measure", "measure", "medida"},
    Entry{"value", "value", "valor"},
    Entry{"unit", "unit", "unidad"},
    Entry{"undefined", "undefined", "sin definir"},
    Entry{"no_measures", "No measures were recorded.", "No se registraron medidas."},
    Entry{"pictures", "Pictures", "Imágenes"},
    Entry{"events", "Events", "Sucesos"},
    Entry{"more_events", "Further events are in the run file.",
          "Los demás sucesos están en el archivo de la ejecución."},
    Entry{"level_info", "note", "nota"},
    Entry{"level_warning", "warning", "aviso"},
    Entry{"level_error", "error", "error"},
    Entry{"comparison", "Comparison", "Comparación"},
    Entry{"batch", "batch", "serie"},
    Entry{"runs", "runs", "ejecuciones"},
    Entry{"successes", "successes", "éxitos"},
    Entry{"share", "share", "proporción"},
    Entry{"interval", "95 % interval", "intervalo del 95 %"},
    Entry{"quartile_1", "1st quartile", "1.er cuartil"},
    Entry{"median", "median", "mediana"},
    Entry{"quartile_3", "3rd quartile", "3.er cuartil"},
    Entry{"without_value", "without value", "sin valor"},
    Entry{"spread", "middle half", "mitad central"},
    Entry{
        "about_comparison",
        "Quartiles by linear interpolation; the interval of a share after Wilson. The bar spans the middle half of the "
        "runs, its mark is the median.",
        "Cuartiles por interpolación lineal; el intervalo de una proporción según Wilson. La barra abarca la mitad "
        "central de las ejecuciones y su marca es la mediana."},
};

/// A key of the dictionary; one that is not there does not compile.
class Key {
 public:
  consteval Key(const char* key) : entry_(&kEntries[find(key)]) {}  // NOLINT: reads as the word it stands for
  constexpr const Entry& entry() const noexcept { return *entry_; }

 private:
  static consteval std::size_t find(std::string_view key) {
    for (std::size_t i = 0; i < kEntries.size(); ++i)
      if (std::string_view(kEntries[i].key) == key) return i;
    throw "no such word";  // a compile-time error
  }
  const Entry* entry_;
};

constexpr std::string_view say(Key key, plot::Language language) noexcept {
  return language == plot::Language::Spanish ? key.entry().spanish : key.entry().english;
}

}  // namespace ganglion::report
