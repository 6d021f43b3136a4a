#pragma once

#include "ganglion/studio/document/edit.h"
#include "ganglion/studio/document/sheet.h"

namespace ganglion::studio {

/// One operation on a sheet: what it needs is in `what`. Ids it makes go into `ids`.
using Operation = Result<void> (*)(Sheet& sheet, const Json& what, std::vector<std::string>& ids);

Result<void> add_component(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> remove_components(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> rename_component(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> set_member(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> unset_member(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> connect(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> disconnect(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> reorder(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> move(Sheet& sheet, const Json& what, std::vector<std::string>& ids);
Result<void> paste(Sheet& sheet, const Json& what, std::vector<std::string>& ids);

/// A field of an operation. Fails with BadType.
Result<std::string> text_in(const Json& what, const char* key);
/// The component it names. Fails with UnknownKey.
Result<const ComponentSource*> component_in(const Sheet& sheet, const Json& what);
/// A JSON value as TOML. Fails with BadType for what no member of ours is.
Result<std::string> toml_of(const Json& value);
/// Fails with BadParameter for what read_controller() would not take.
Result<void> check_id(const std::string& id);
/// Notes the positions, [x, y] each, in [layout].
void place_boxes(Sheet& sheet, const std::vector<std::pair<std::string, std::string>>& positions);
/// "[120, 80]". Fails with BadType.
Result<std::string> position_of(const Json& value);
/// Whether a wire's text comes from the component: "id", "id.x", "id@previous".
bool comes_from(std::string_view wire, std::string_view id) noexcept;

}  // namespace ganglion::studio
