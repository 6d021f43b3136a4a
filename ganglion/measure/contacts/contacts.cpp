#include "ganglion/measure/followed.h"

namespace ganglion {
namespace {

constexpr std::array kFollowed = {
    Followed{"contacts",
             "contacts",
             "",
             {"contacts begun; pushing on is none", "contactos que empezaron; seguir empujando no cuenta"}},
    Followed{"fastest_contact_mps",
             "fastest_contact_mps",
             "m/s",
             {"speed along the normal at which the hardest contact began",
              "velocidad normal con que empezó el contacto más fuerte"}},
};

}  // namespace

extern constinit const MeasureKind contacts_kind{
    .descriptor =
        {.component_class = ComponentClass::Measure,
         .name = "Contacts",
         .summary = {"Contacts begun, and how hard the hardest was: contacts, fastest_contact_mps",
                     "Contactos que empezaron, y con qué fuerza el más fuerte: contacts, fastest_contact_mps"},
         .source = "ours"},
    .order = 2,
    .figures = [](const MeasureScope& scope) { return followed_figures(scope, kFollowed); },
    .make = [](const MeasureScope& scope) { return make_followed(scope, kFollowed); }};

}  // namespace ganglion
