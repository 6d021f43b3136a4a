#include "ganglion/graph/kind_list.h"

namespace ganglion {
namespace {

template <class Product>
void append(std::vector<const Descriptor*>& into, std::span<const Kind<Product>* const> kinds) {
  for (const Kind<Product>* kind : kinds) into.push_back(&kind->descriptor);
}

}  // namespace

std::vector<const Descriptor*> descriptors_of(const KindList& kinds, ComponentClass component_class) {
  std::vector<const Descriptor*> result;
  switch (component_class) {
    case ComponentClass::Sensing:
      append(result, kinds.sensing);
      break;
    case ComponentClass::Goal:
      append(result, kinds.goal);
      break;
    case ComponentClass::Acting:
      append(result, kinds.acting);
      break;
    case ComponentClass::Coordinator:
      append(result, kinds.coordinator);
      break;
    default:
      break;
  }
  return result;
}

const Descriptor* find_descriptor(const KindList& kinds, ComponentClass component_class, std::string_view name) {
  for (const Descriptor* descriptor : descriptors_of(kinds, component_class)) {
    if (descriptor->name == name || (!name.empty() && descriptor->paper_name == name)) return descriptor;
  }
  return nullptr;
}

}  // namespace ganglion
