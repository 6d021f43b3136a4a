#pragma once

#include "ganglion/studio/api/router.h"
#include "ganglion/studio/folder/folder.h"

namespace ganglion::studio {

/// The commands about the text of a controller that is being drawn; nothing is written. The folder must outlive the
/// router.
void add_document_routes(Router& router, const Folder& folder);

}  // namespace ganglion::studio
