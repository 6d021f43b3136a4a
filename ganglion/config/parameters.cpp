#include "ganglion/config/table.h"

namespace ganglion::config {
namespace {

void read(Table& table, const ParameterDescriptor& descriptor, Parameters& into) {
  const Range range{descriptor.min, descriptor.max};
  switch (descriptor.type) {
    case ParameterType::Real:
      into.set(descriptor.name, table.number(descriptor.name, descriptor.preset, range));
      break;
    case ParameterType::Integer:
      into.set(descriptor.name, table.integer(descriptor.name, static_cast<int>(descriptor.preset), range));
      break;
    case ParameterType::Boolean:
      into.set(descriptor.name, table.boolean(descriptor.name, descriptor.preset != 0) ? 1 : 0);
      break;
    case ParameterType::Choice:
      into.set(descriptor.name, table.choice(descriptor.name, descriptor.choices, static_cast<int>(descriptor.preset)));
      break;
    case ParameterType::Word:
      into.set_word(descriptor.name, table.text(descriptor.name, descriptor.preset_word));
      break;
    case ParameterType::Reals:
      into.set_reals(descriptor.name,
                     table.numbers(descriptor.name, {descriptor.preset_reals.begin(), descriptor.preset_reals.end()},
                                   static_cast<std::size_t>(descriptor.count), range));
      break;
  }
}

}  // namespace

Parameters Table::parameters(std::span<const ParameterDescriptor> descriptors) {
  Parameters result(descriptors);
  for (const ParameterDescriptor& descriptor : descriptors) {
    asks(descriptor.name, {.parameter = &descriptor});
    const bool absent = !has(descriptor.name);
    known(descriptor.name);
    if (!absent) read(*this, descriptor, result);
  }
  return result;
}

}  // namespace ganglion::config
