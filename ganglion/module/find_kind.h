#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ganglion/base/text.h"
#include "ganglion/config/table.h"
#include "ganglion/module/component.h"

namespace ganglion {

/// The kind of that name; a problem with the nearest names if there is none.
template <class Product>
const Kind<Product>* find_kind(config::Table& table, std::span<const Kind<Product>* const> kinds) {
  const std::string name = table.text("kind");
  std::vector<std::string> names;
  for (const auto* kind : kinds) {
    if (!name.empty() && (kind->descriptor.name == name || kind->descriptor.paper_name == name)) {
      table.is_of(kind->descriptor);
      return kind;
    }
    names.emplace_back(kind->descriptor.name);
  }
  if (table.has("kind") && !name.empty()) {
    const Sentence what =
        say({"there is no kind \"{}\"{}", "no existe el tipo \"{}\"{}"}, name, suggestion(name, names));
    table.problem("kind", Error{ErrorCode::UnknownKey, what, {}, Subject{.found = name, .choices = names}});
  }
  // Its parameters cannot be told from slips: only the kind is reported.
  for (const std::string& key : table.keys()) table.known(key);
  return nullptr;
}

/// A device of that kind, to see whether its parameters agree; null with a problem if they do not.
template <class Product>
std::unique_ptr<Product> made(const Kind<Product>& kind, const Parameters& parameters, const config::Table& table) {
  auto product = kind.make(parameters);
  if (product) return std::move(*product);
  table.problem("kind", product.error());
  return nullptr;
}

}  // namespace ganglion
