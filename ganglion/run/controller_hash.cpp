#include "ganglion/run/controller_hash.h"

#include "ganglion/base/hash.h"
#include "ganglion/graph/digest.h"

namespace ganglion {

std::string controller_hash(const OpenedFile& file, const ControllerModel& controller,
                            const std::vector<config::Override>& overrides) {
  std::uint64_t hash = file.hash();
  for (const config::Override& override : overrides)
    hash = combine(hash, hash_name(override.path + "=" + override.value));
  for (const ComponentModel& component : controller.components) {
    for (const ParameterDescriptor& parameter : component.parameters.descriptors()) {
      if (parameter.type != ParameterType::File) continue;
      hash = combine(hash, hash_name(component.parameters.file(parameter.name).text));
    }
  }
  return hex(hash);
}

}  // namespace ganglion
