#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/studio/document/list_items.h"
#include "ganglion/studio/document/operations.h"

namespace ganglion::studio {
namespace {

/// Whether a port takes a list of wires: as its kind says, or, where that is unknown, as it stands in the file.
bool takes_many(const config::Sheet& sheet, const config::ItemSource& component, const std::string& port) {
  const auto found = sheet.member(component.id, "in." + port);
  const bool list = found && found->member->value.of(sheet.text()).starts_with('[');
  const auto kind = sheet.member(component.id, "kind");
  if (!kind) return list;
  const std::string name = config::unquoted(kind->member->value.of(sheet.text()));
  for (const Descriptor* descriptor : all_descriptors()) {
    if (name_of(descriptor->component_class) != component.list) continue;
    if (descriptor->name != name && (name.empty() || descriptor->paper_name != name)) continue;
    const PortDescriptor* known = descriptor->port(port);
    if (known == nullptr) return list;
    return known->many || (list && known->role == PortRole::Request);
  }
  return list;
}

struct Ends {
  std::string id;
  std::string port;
};

/// The receiving end; afterwards an inline `in` is written out, so that there is a line for each port.
Result<Ends> ends_of(config::Sheet& sheet, const Json& what) {
  const auto component = component_in(sheet, what);
  if (!component) return tl::unexpected<Error>(component.error());
  auto port = text_in(what, "port");
  if (!port) return tl::unexpected<Error>(port.error());
  const bool bare = !port->empty() && std::all_of(port->begin(), port->end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (!bare)
    return fail(ErrorCode::BadParameter, {"\"{}\" is no name of a port", "\"{}\" no es el nombre de un puerto"}, *port);
  const std::string id = (*component)->id;
  sheet.expand_inline(id, "in");
  return Ends{id, std::move(*port)};
}

/// What a wired input holds.
struct WiredInput {
  Ends ends;
  config::Sheet::Found found;
  std::vector<config::Region> items;  ///< The texts that name where its wires come from.
};

/// Fails with UnknownKey where the input is not wired.
Result<WiredInput> wired_input(config::Sheet& sheet, const Json& what) {
  auto ends = ends_of(sheet, what);
  if (!ends) return tl::unexpected<Error>(ends.error());
  const auto found = sheet.member(ends->id, "in." + ends->port);
  if (!found)
    return fail(ErrorCode::UnknownKey, {"{}: input \"{}\" is not wired", "{}: la entrada \"{}\" no está conectada"},
                ends->id, ends->port);
  return WiredInput{std::move(*ends), *found, config::strings_in(sheet.text(), found->member->value)};
}

/// Behind the blank lines below a section; where it is the last, or a comment follows, they stay.
std::size_t blank_end(std::string_view text, const config::SectionSource& section) {
  const bool blank =
      config::Region{section.body_end, section.end}.of(text).find_first_not_of(" \t\r\n") == std::string_view::npos;
  return blank && section.end < text.size() ? section.end : section.body_end;
}

}  // namespace

Result<void> connect(config::Sheet& sheet, const Json& what, std::vector<std::string>&) {
  const auto from = text_in(what, "from");
  if (!from) return tl::unexpected<Error>(from.error());
  const auto ends = ends_of(sheet, what);
  if (!ends) return tl::unexpected<Error>(ends.error());
  const std::string key = "in." + ends->port;
  const auto found = sheet.member(ends->id, key);
  const bool many = takes_many(sheet, *sheet.find(ends->id), ends->port);
  if (!many || !found) {
    sheet.set(ends->id, key, many ? "[" + config::toml_text(*from) + "]" : config::toml_text(*from));
    return {};
  }
  const config::Region value = found->member->value;
  const std::string& text = sheet.text();
  const std::vector<config::Region> items = config::strings_in(text, value);
  for (const config::Region& item : items) {
    if (config::unquoted(item.of(text)) == *from)
      return fail(ErrorCode::BadWire, {"\"{}\" is wired to it already", "\"{}\" ya está conectado a ella"}, *from);
  }
  if (!value.of(text).starts_with('[')) {  // a list of one, written without brackets
    sheet.replace(value, fmt::format("[{}, {}]", value.of(text), config::toml_text(*from)));
    return {};
  }
  const auto index = what.find("index");
  const bool between = index != what.end() && index->is_number_unsigned();
  put_in(sheet, value, between ? index->get<std::size_t>() : items.size(), config::toml_text(*from));
  return {};
}

Result<void> disconnect(config::Sheet& sheet, const Json& what, std::vector<std::string>&) {
  const auto input = wired_input(sheet, what);
  if (!input) return tl::unexpected<Error>(input.error());
  const auto& [ends, found, items] = *input;
  const std::string& text = sheet.text();
  if (!what.contains("from")) {
    sheet.erase(ends.id, found);
    return {};
  }
  const auto from = text_in(what, "from");
  if (!from) return tl::unexpected<Error>(from.error());
  const auto item = std::find_if(items.begin(), items.end(),
                                 [&](const config::Region& one) { return config::unquoted(one.of(text)) == *from; });
  if (item == items.end()) {
    return fail(ErrorCode::UnknownKey,
                {"{}: no wire comes from \"{}\" to input \"{}\"", "{}: ningún cable va de \"{}\" a la entrada \"{}\""},
                ends.id, *from, ends.port);
  }
  if (items.size() == 1) {
    sheet.erase(ends.id, found);
  } else {
    take_out(sheet, found.member->value, *item);
  }
  return {};
}

Result<void> reorder(config::Sheet& sheet, const Json& what, std::vector<std::string>&) {
  const auto input = wired_input(sheet, what);
  if (!input) return tl::unexpected<Error>(input.error());
  const std::vector<config::Region>& items = input->items;
  const std::string& text = sheet.text();
  std::vector<std::string> now, wanted;
  for (const config::Region& item : items) now.push_back(config::unquoted(item.of(text)));
  const auto order = what.find("order");
  if (order == what.end() || !order->is_array())
    return fail(ErrorCode::BadType, {"\"order\" must be a list of texts", "\"order\" debe ser una lista de textos"});
  for (const Json& one : *order) wanted.push_back(one.is_string() ? one.get<std::string>() : std::string());
  if (!std::is_permutation(now.begin(), now.end(), wanted.begin(), wanted.end())) {
    return fail(ErrorCode::BadParameter,
                {"\"order\" must name the same wires: {}", "\"order\" debe nombrar los mismos cables: {}"}, join(now));
  }
  std::vector<std::size_t> order_of;  // which of them stands there then
  for (const std::string& one : wanted) {
    std::size_t at = 0;
    while (now[at] != one || std::find(order_of.begin(), order_of.end(), at) != order_of.end()) ++at;
    order_of.push_back(at);
  }
  put_in_order(sheet, input->found.member->value, order_of);
  return {};
}

/// Wires, and boxes of [layout], follow the name.
Result<void> rename_component(config::Sheet& sheet, const Json& what, std::vector<std::string>& ids) {
  const auto component = component_in(sheet, what);
  if (!component) return tl::unexpected<Error>(component.error());
  const auto to = text_in(what, "to");
  if (!to) return tl::unexpected<Error>(to.error());
  if (auto good = check_id(*to); !good) return good;
  const std::string id = (*component)->id;
  if (*to != id && !sheet.is_free(*to))
    return fail(ErrorCode::BadParameter, {"\"{}\" is the id of another", "\"{}\" es el id de otro componente"}, *to);
  ids.push_back(*to);
  if (*to == id) return {};
  sheet.set(id, "id", config::toml_text(*to));
  const std::string& text = sheet.text();
  for (const config::Sheet::Entry& input : sheet.entries("in")) {
    for (const config::Region& item : config::strings_in(text, input.member->value)) {
      const std::string wire = config::unquoted(item.of(text));
      if (comes_from(wire, id)) sheet.replace(item, config::toml_text(*to + wire.substr(id.size())));
    }
  }
  for (const config::SectionSource& section : sheet.map().sections) {
    if (section.name != "layout" || section.list) continue;
    const config::MemberSource* box = section.member(id);
    if (box != nullptr) sheet.replace(sheet.key_of(*box), *to);
  }
  return {};
}

Result<void> remove_components(config::Sheet& sheet, const Json& what, std::vector<std::string>&) {
  const auto ids = what.find("ids");
  if (ids == what.end() || !ids->is_array())
    return fail(ErrorCode::BadType, {"\"ids\" must be a list of texts", "\"ids\" debe ser una lista de textos"});
  std::vector<std::string> gone;
  for (const Json& id : *ids) {
    const auto component = component_in(sheet, Json{{"id", id}});
    if (!component) return tl::unexpected<Error>(component.error());
    gone.push_back((*component)->id);
  }
  std::sort(gone.begin(), gone.end());
  const auto is_gone = [&](std::string_view id) { return std::binary_search(gone.begin(), gone.end(), id); };
  const auto source_of = [](const std::string& wire) { return wire.substr(0, wire.find_first_of(".@")); };
  std::vector<std::string> inlined;
  for (const config::Sheet::Entry& input : sheet.entries("in")) {
    if (!input.member->inline_key.empty()) inlined.push_back(input.item->id);
  }
  for (const std::string& id : inlined) sheet.expand_inline(id, "in");
  const std::string& text = sheet.text();
  for (const config::Sheet::Entry& input : sheet.entries("in")) {
    if (is_gone(input.item->id)) continue;
    const std::vector<config::Region> items = config::strings_in(text, input.member->value);
    std::vector<config::Region> left;
    std::copy_if(items.begin(), items.end(), std::back_inserter(left),
                 [&](const config::Region& item) { return !is_gone(source_of(config::unquoted(item.of(text)))); });
    if (left.size() == items.size()) continue;
    if (left.empty()) {
      sheet.replace(input.member->lines, "");
      continue;
    }
    for (const config::Region& item : items) {
      if (is_gone(source_of(config::unquoted(item.of(text))))) take_out(sheet, input.member->value, item);
    }
  }
  for (const config::ItemSource& component : sheet.items()) {
    if (!is_gone(component.id)) continue;
    for (const std::size_t index : component.sections) {
      const config::SectionSource& section = sheet.map().sections[index];
      sheet.replace({section.begin, blank_end(text, section)}, "");
    }
  }
  for (const config::SectionSource& section : sheet.map().sections) {
    if (section.name != "layout" || section.list) continue;
    for (const config::MemberSource& box : section.members) {
      if (is_gone(box.key)) sheet.replace(box.lines, "");
    }
  }
  return {};
}

}  // namespace ganglion::studio
