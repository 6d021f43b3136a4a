#include "ganglion/studio/document/edit.h"

#include <array>
#include <cmath>

#include "ganglion/base/text.h"
#include "ganglion/config/format.h"
#include "ganglion/studio/document/component_lists.h"
#include "ganglion/studio/document/operations.h"

namespace ganglion::studio {
namespace {

struct Named {
  std::string_view name;
  Operation carry_out;
};
constexpr std::array kOperations = {Named{"add", add_component},
                                    Named{"remove", remove_components},
                                    Named{"rename", rename_component},
                                    Named{"set", set_member},
                                    Named{"unset", unset_member},
                                    Named{"connect", connect},
                                    Named{"disconnect", disconnect},
                                    Named{"reorder", reorder},
                                    Named{"move", move},
                                    Named{"paste", paste}};

/// Each operation goes through the text, which grows: together they may go through so much.
constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr std::size_t kMostText = std::size_t{8} << 20;

Result<void> carry_out(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids) {
  const auto name = text_in(what, "op");
  if (!name) return tl::unexpected<Error>(name.error());
  std::vector<std::string> names;
  for (const Named& one : kOperations) {
    if (one.name == *name) return one.carry_out(sheet, what, ids);
    names.emplace_back(one.name);
  }
  return fail(ErrorCode::UnknownKey, {"there is no operation \"{}\"{}", "no hay ninguna operación \"{}\"{}"}, *name,
              suggestion(*name, names));
}

/// Whether it has the one layout of our files: else it has its author's, which is kept.
bool laid_out(std::string_view text) {
  const auto formatted = config::format(text, "");
  return formatted && *formatted == text;
}

}  // namespace

Result<Edited> edit(std::string_view text, const Json& operations) {
  if (!operations.is_array())
    return fail(ErrorCode::BadType, {"operations must be a list", "operations debe ser una lista"});
  config::Sheet sheet(std::string(text), kComponentLists);
  Edited edited;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    bytes += sheet.text().size();
    if (sheet.text().size() > kMostText || (i > 0 && bytes > kMostBytes)) {
      return fail_at({"", static_cast<int>(i)}, ErrorCode::TooLarge,
                     {"that is too much at once for a text so long", "es demasiado a la vez para un texto tan largo"});
    }
    auto done = carry_out(sheet, operations[i], edited.ids);
    if (!done) {
      done.error().place = {"", static_cast<int>(i)};
      return tl::unexpected<Error>(std::move(done.error()));
    }
    sheet.commit();
  }
  edited.text = sheet.take();
  if (!laid_out(text)) return edited;
  if (auto formatted = config::format(edited.text, "")) edited.text = std::move(*formatted);
  return edited;
}

Result<std::string> text_in(const Json& what, const char* key) {
  if (what.is_object()) {
    const auto found = what.find(key);
    if (found != what.end() && found->is_string()) return found->get<std::string>();
  }
  return fail(ErrorCode::BadType, {"\"{}\" must be a text", "\"{}\" debe ser un texto"}, key);
}

Result<const config::ItemSource*> component_in(const config::Sheet& sheet, const Json& what) {
  const auto id = text_in(what, "id");
  if (!id) return tl::unexpected<Error>(id.error());
  const config::ItemSource* found = sheet.find(*id);
  if (found == nullptr) {
    return fail(ErrorCode::UnknownKey, {"there is no component \"{}\"{}", "no hay ningún componente \"{}\"{}"}, *id,
                suggestion(*id, sheet.ids()));
  }
  return found;
}

Result<std::string> toml_of(const Json& value) {
  if (value.is_boolean()) return std::string(value.get<bool>() ? "true" : "false");
  if (value.is_number_integer()) return value.dump();
  if (value.is_number() && std::isfinite(value.get<double>())) return shortest(value.get<double>());
  if (value.is_string()) return config::toml_text(value.get<std::string>());
  if (!value.is_array())
    return fail(ErrorCode::BadType, {"a value must be a number, a text, true or false, or a list",
                                     "un valor debe ser un número, un texto, true o false, o una lista"});
  std::string list;
  for (const Json& item : value) {
    const auto toml = toml_of(item);
    if (!toml) return toml;
    list += (list.empty() ? "" : ", ") + *toml;
  }
  return "[" + list + "]";
}

Result<void> check_id(const std::string& id) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  bool good = !id.empty() && id.size() <= 64 && letter(id.front());
  for (const char c : id) good = good && (letter(c) || (c >= '0' && c <= '9'));
  if (good) return {};
  return fail(ErrorCode::BadParameter,
              {"\"{}\" is no id: write a letter, then letters, digits or _, at most 64 in all",
               "\"{}\" no es un id: escriba una letra y después letras, cifras o _, 64 como máximo en total"},
              id);
}

bool comes_from(std::string_view wire, std::string_view id) noexcept {
  if (!wire.starts_with(id)) return false;
  return wire.size() == id.size() || wire[id.size()] == '.' || wire[id.size()] == '@';
}

}  // namespace ganglion::studio
