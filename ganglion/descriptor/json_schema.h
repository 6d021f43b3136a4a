#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// The version of JSON Schema our schemas are written in, for "$schema".
inline constexpr std::string_view kJsonSchemaDialect = "https://json-schema.org/draft/2020-12/schema";

/// JSON Schema of a parameter's value: type, limits, choices, default and, as description, its help with unit.
nlohmann::ordered_json parameter_schema(const ParameterDescriptor& parameter);

/// Its default, as such a value.
nlohmann::ordered_json preset_json(const ParameterDescriptor& parameter);

/// JSON Schema of the table of a component of this kind: `kind`, which is required, its parameters
/// and those of its class. Who reads such
/// tables adds the keys of its own; whatever is not listed in the end is an unknown key.
nlohmann::ordered_json kind_schema(const Descriptor& kind);

/// JSON Schema of a list, [[...]], of such tables, each of one of these kinds.
nlohmann::ordered_json kinds_schema(const std::vector<nlohmann::ordered_json>& kinds);

}  // namespace ganglion
