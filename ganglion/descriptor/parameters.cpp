#include "ganglion/descriptor/parameters.h"

#include "ganglion/base/expects.h"

namespace ganglion {

Parameters::Parameters(std::span<const ParameterDescriptor> descriptors) : descriptors_(descriptors) {
  for (const ParameterDescriptor& descriptor : descriptors) {
    values_.push_back({descriptor.preset,
                       std::string(descriptor.preset_word),
                       {descriptor.preset_reals.begin(), descriptor.preset_reals.end()},
                       false});
  }
}

Parameters::Value& Parameters::set_at(std::string_view name) {
  for (std::size_t i = 0; i < descriptors_.size(); ++i) {
    if (descriptors_[i].name != name) continue;
    values_[i].given = true;
    return values_[i];
  }
  expects(false);  // the kind asks for a parameter that its own descriptor does not list
  return values_.front();
}

bool Parameters::given(std::string_view name) const {
  for (std::size_t i = 0; i < descriptors_.size(); ++i) {
    if (descriptors_[i].name == name) return values_[i].given;
  }
  expects(false);
  return false;
}

const Parameters::Value& Parameters::at(std::string_view name, ParameterType type) const {
  for (std::size_t i = 0; i < descriptors_.size(); ++i) {
    if (descriptors_[i].name != name) continue;
    expects(descriptors_[i].type == type);
    return values_[i];
  }
  expects(false);
  return values_.front();
}

double Parameters::real(std::string_view name) const { return at(name, ParameterType::Real).number; }
int Parameters::integer(std::string_view name) const {
  return static_cast<int>(at(name, ParameterType::Integer).number);
}
bool Parameters::boolean(std::string_view name) const { return at(name, ParameterType::Boolean).number != 0; }
int Parameters::choice_index(std::string_view name) const {
  return static_cast<int>(at(name, ParameterType::Choice).number);
}
std::string_view Parameters::choice(std::string_view name) const {
  const auto index = static_cast<std::size_t>(choice_index(name));
  for (const ParameterDescriptor& descriptor : descriptors_) {
    if (descriptor.name == name) return descriptor.choices[index];
  }
  return {};
}
const std::string& Parameters::word(std::string_view name) const { return at(name, ParameterType::Word).word; }
std::span<const double> Parameters::reals(std::string_view name) const { return at(name, ParameterType::Reals).reals; }

void Parameters::set(std::string_view name, double value) { set_at(name).number = value; }
void Parameters::set_word(std::string_view name, std::string value) { set_at(name).word = std::move(value); }
void Parameters::set_reals(std::string_view name, std::vector<double> values) {
  set_at(name).reals = std::move(values);
}

}  // namespace ganglion
