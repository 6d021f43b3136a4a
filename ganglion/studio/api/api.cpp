#include "ganglion/studio/api/api.h"

#include "ganglion/studio/api/choice_routes.h"
#include "ganglion/studio/api/document_routes.h"
#include "ganglion/studio/api/reach_routes.h"

namespace ganglion::studio {

Api::Api(Folder folder, std::vector<AllowedProgram> programs, const Hooks& hooks)
    : folder_(std::move(folder)),
      programs_(std::move(programs)),
      listing_(folder_),
      wanted_(folder_, programs_),
      run_(hooks.on_hub, hooks.later),
      files_(router_, folder_, listing_, hooks.on_hub),
      link_(router_, folder_, wanted_, hooks.on_hub),
      runs_(router_, folder_, wanted_, run_),
      recordings_(router_, folder_, listing_) {
  add_choice_routes(router_, programs_);
  add_document_routes(router_, folder_);
  add_reach_routes(router_, run_);
}

}  // namespace ganglion::studio
