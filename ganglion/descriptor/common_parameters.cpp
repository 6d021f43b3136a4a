#include "ganglion/descriptor/common_parameters.h"

#include <array>

namespace ganglion {
namespace {

constexpr std::array kActing = {
    parameter<ActingCommon, &ActingCommon::tolerance>(
        {.name = "tolerance",
         .title = {"tolerance", "tolerancia"},
         .help =
             {"A request is satisfied within this, in the unit of the first feedback; a list has one number for each "
              "of its values. Left out: 0.05 m, 5 deg, else 0",
              "Una solicitud se satisface con este margen, en la unidad de la primera retroalimentación; una lista "
              "tiene un número por cada valor. Si falta: 0,05 m, 5 grados, o 0"},
         .min = 0,
         .ours = true}),
    parameter<ActingCommon, &ActingCommon::preemption>(
        {.name = "preemption",
         .title = {"pre-emption", "desplazamiento"},
         .help = {"Whether a goal of a higher class may take the module over",
                  "Si un objetivo de una clase mayor puede hacerse con el módulo"},
         .ours = true}),
};

constexpr std::array kGoal = {
    parameter<GoalCommon, &GoalCommon::priority_class>(
        {.name = "priority_class",
         .title = {"priority class", "clase de prioridad"},
         .help = {"A higher class may pre-empt a lower one", "Una clase mayor puede desplazar a una menor"},
         .min = 0,
         .max = 100,
         .ours = true}),
};

}  // namespace

std::span<const ParameterDescriptor> common_parameters(ComponentClass component_class) noexcept {
  if (component_class == ComponentClass::Acting) return kActing;
  if (component_class == ComponentClass::Goal) return kGoal;
  return {};
}

}  // namespace ganglion
