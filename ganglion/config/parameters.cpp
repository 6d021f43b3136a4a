#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/config/table.h"

namespace ganglion::config {
namespace {

std::string numbers_text(std::span<const double> numbers) {
  std::vector<std::string> words;
  for (const double number : numbers) words.push_back(shortest(number));
  return join(words);
}

/// Takes a number within the parameter's range; one that is not among those allowed is reported.
void set_number(Table& table, const ParameterDescriptor& descriptor, double number, Parameters& into) {
  const auto& allowed = descriptor.allowed;
  if (allowed.empty() || std::find(allowed.begin(), allowed.end(), number) != allowed.end()) {
    into.set(descriptor.name, number);
    return;
  }
  table.problem(descriptor.name, ErrorCode::BadParameter,
                {"{} is {}, must be one of {}", "{} es {}, debe ser uno de {}"}, descriptor.name, shortest(number),
                numbers_text(allowed));
}

void read(Table& table, const ParameterDescriptor& descriptor, Parameters& into) {
  const Range range{descriptor.min, descriptor.max};
  const std::string_view name = descriptor.name;
  const ParameterValue preset = descriptor.preset();
  const auto number = [&preset] { return std::get<double>(preset); };
  switch (descriptor.type) {
    case ParameterType::Real:
      set_number(table, descriptor, table.number(name, number(), range), into);
      break;
    case ParameterType::Integer:
      set_number(table, descriptor, table.integer(name, static_cast<int>(number()), range), into);
      break;
    case ParameterType::Boolean:
      into.set(name, table.boolean(name, number() != 0) ? 1 : 0);
      break;
    case ParameterType::Choice:
      into.set(name, table.choice(name, descriptor.choices, static_cast<int>(number())));
      break;
    case ParameterType::Word:
      into.set_word(name, table.text(name, std::get<std::string>(preset)));
      break;
    case ParameterType::Reals:
      into.set_reals(name, table.numbers(name, std::get<std::vector<double>>(preset),
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
