#include "ganglion/descriptor/parameters.h"

#include <fmt/ranges.h>

#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"

namespace ganglion {
namespace {

/// What is no number: a word, numbers, a file.
template <class Held>
std::string text_of(const Held& held) {
  if constexpr (std::is_same_v<Held, FileText>) {
    return fmt::format("{:016x}", hash_name(held.text));
  } else if constexpr (std::is_same_v<Held, std::string>) {
    return held;
  } else {
    return fmt::format("{}", held);
  }
}

}  // namespace

Parameters::Parameters(std::span<const ParameterDescriptor> descriptors) : descriptors_(descriptors) {
  for (const ParameterDescriptor& descriptor : descriptors) values_.push_back({descriptor.preset(), false});
}

std::size_t Parameters::index_of(std::string_view name) const {
  for (std::size_t i = 0; i < descriptors_.size(); ++i) {
    if (descriptors_[i].name == name) return i;
  }
  expects(false);  // whoever asks names a parameter that the descriptor does not list
  return 0;
}

const ParameterValue& Parameters::value(std::string_view name) const { return values_[index_of(name)].value; }

bool Parameters::given(std::string_view name) const { return values_[index_of(name)].given; }

const ParameterValue& Parameters::at(std::string_view name, ParameterType type) const {
  const std::size_t index = index_of(name);
  expects(descriptors_[index].type == type);
  return values_[index].value;
}

double Parameters::real(std::string_view name) const { return std::get<double>(at(name, ParameterType::Real)); }
int Parameters::integer(std::string_view name) const {
  return static_cast<int>(std::get<double>(at(name, ParameterType::Integer)));
}
bool Parameters::boolean(std::string_view name) const {
  return std::get<double>(at(name, ParameterType::Boolean)) != 0;
}
int Parameters::choice_index(std::string_view name) const {
  return static_cast<int>(std::get<double>(at(name, ParameterType::Choice)));
}
std::string_view Parameters::choice(std::string_view name) const {
  return descriptors_[index_of(name)].choices[static_cast<std::size_t>(choice_index(name))];
}
const std::string& Parameters::word(std::string_view name) const {
  return std::get<std::string>(at(name, ParameterType::Word));
}
std::span<const double> Parameters::reals(std::string_view name) const {
  return std::get<std::vector<double>>(at(name, ParameterType::Reals));
}
const FileText& Parameters::file(std::string_view name) const {
  return std::get<FileText>(at(name, ParameterType::File));
}

std::string Parameters::text(std::string_view name) const {
  const ParameterDescriptor& descriptor = descriptors_[index_of(name)];
  const ParameterValue& held = value(name);
  const auto* number = std::get_if<double>(&held);
  if (number == nullptr) return std::visit([](const auto& other) { return text_of(other); }, held);
  if (descriptor.type == ParameterType::Boolean) return *number != 0 ? "true" : "false";
  if (descriptor.type == ParameterType::Choice) return std::string(choice(name));
  return shortest(*number);
}

void Parameters::set_value(std::string_view name, ParameterValue value) {
  Value& found = values_[index_of(name)];
  expects(found.value.index() == value.index());
  found = {std::move(value), true};
}

void Parameters::set(std::string_view name, double value) { set_value(name, value); }
void Parameters::set_word(std::string_view name, std::string value) { set_value(name, std::move(value)); }
void Parameters::set_reals(std::string_view name, std::vector<double> values) { set_value(name, std::move(values)); }
void Parameters::set_file(std::string_view name, FileText file) { set_value(name, std::move(file)); }

}  // namespace ganglion
