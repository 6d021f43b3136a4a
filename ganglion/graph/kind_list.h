#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ganglion/module/acting_module.h"
#include "ganglion/module/coordinator.h"
#include "ganglion/module/global_goal.h"
#include "ganglion/module/sensing_module.h"

namespace ganglion {

/// The kinds a controller may be built from. The graph is handed them and knows none by name.
struct KindList {
  std::span<const SensingModuleKind* const> sensing;
  std::span<const GlobalGoalKind* const> goal;
  std::span<const ActingModuleKind* const> acting;
  std::span<const CoordinatorKind* const> coordinator;
};

/// The kind of that name or paper name, or null.
template <class Product>
const Kind<Product>* find_kind(std::span<const Kind<Product>* const> kinds, std::string_view name) noexcept {
  for (const Kind<Product>* kind : kinds) {
    const Descriptor& descriptor = kind->descriptor;
    if (descriptor.name == name || (!name.empty() && descriptor.paper_name == name)) return kind;
  }
  return nullptr;
}

/// The descriptors of one class of controller components, in the list's order; none for Sensation.
std::vector<const Descriptor*> descriptors_of(const KindList& kinds, ComponentClass component_class);

/// The descriptor of that class and name or paper name, or null.
const Descriptor* find_descriptor(const KindList& kinds, ComponentClass component_class, std::string_view name);

}  // namespace ganglion
