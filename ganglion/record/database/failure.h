#pragma once

#include <string>

#include "ganglion/base/result.h"

struct sqlite3;

namespace ganglion {

/// The connection's last failure, in our words and codes; SQLite's own words follow as they are.
Error database_failure(sqlite3* connection, const std::string& file);

}  // namespace ganglion
