#pragma once

#include "ganglion/config/source/sheet.h"
#include "ganglion/studio/document/edit.h"

namespace ganglion::studio {

/// One operation on a sheet: what it needs is in `what`. Ids it makes go into `ids`.
using Operation = Result<void> (*)(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);

Result<void> add_component(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> remove_components(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> rename_component(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> set_member(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> unset_member(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> connect(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> disconnect(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> reorder(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> move(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> paste(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids);

/// A field of an operation. Fails with BadType.
Result<std::string> text_in(const Json& what, const char* key);
/// The component it names. Fails with UnknownKey.
Result<const config::ItemSource*> component_in(const config::Sheet& sheet, const Json& what);
/// A JSON value as TOML. Fails with BadType for what no member of ours is.
Result<std::string> toml_of(const Json& value);
/// Fails with BadParameter for what read_controller() would not take.
Result<void> check_id(const std::string& id);
/// Notes the positions, [x, y] each, in [layout].
void place_boxes(config::Sheet& sheet, const std::vector<std::pair<std::string, std::string>>& positions);
/// "[120, 80]". Fails with BadType.
Result<std::string> position_of(const Json& value);
/// Whether a wire's text comes from the component: "id", "id.x", "id@previous".
bool comes_from(std::string_view wire, std::string_view id) noexcept;

}  // namespace ganglion::studio
