#pragma once

#include <list>
#include <memory>
#include <optional>

#include "ganglion/application/model.h"

namespace ganglion {

/// Reads an application from its file: its key `kind` says which plant it is; without one it describes a robot. Null if
/// there were problems.
std::shared_ptr<const ApplicationModel> read_application(const ApplicationSource& source, Problems& problems);

/// The same of a file that was opened, with what --set changes in it, for its description only.
std::optional<Description> read_description(FileReader& files, int file, std::span<const config::Override> overrides,
                                            Problems& problems);

/// Asks for the keys that [application] of an experiment may have besides those of every application.
void ask_application(config::Table& setting);

/// Whether one of the keys that only a world.toml has stands there.
bool is_world(const config::Value& root);

/// A world.toml, or a map.yaml: every problem.
void check_world(FileReader& files, int file, Problems& problems);

/// JSON Schemas of what applications are made of.
std::string robot_schema();
std::string world_schema();
/// JSON Schema of a plant's file, and what is asked of such files, in samples that together know every key.
std::string plant_schema();
std::list<config::Outline> plant_outlines();

}  // namespace ganglion
