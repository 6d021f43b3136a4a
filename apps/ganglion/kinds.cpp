#include "ganglion/kinds/kinds.h"
#include "commands.h"
#include "ganglion/base/text.h"
#include "ganglion/descriptor/kind_page.h"
#include "ganglion/descriptor/kinds_json.h"
#include "ganglion/plot/pictures/pictures.h"
#include "language.h"
#include "say.h"

namespace ganglion {
namespace {

/// Of components, of what surrounds them, of what judges and of what draws a run.
std::vector<const Descriptor*> every_kind() {
  std::vector<const Descriptor*> kinds = all_descriptors();
  for (const plot::PictureKind* kind : plot::picture_kinds()) kinds.push_back(&kind->descriptor);
  return kinds;
}

int list_kinds() {
  for (const Descriptor* kind : every_kind()) {
    fmt::print("{:<12} {:<26} {:<8} {}\n", name_of(kind->component_class), kind->name, kind->paper_name,
               kind->summary.in(language()));
  }
  return kDone;
}

std::vector<const Descriptor*> matching(const std::string& name) {
  std::vector<const Descriptor*> found;
  for (const Descriptor* kind : every_kind()) {
    if (name.empty() || kind->name == name || kind->paper_name == name) found.push_back(kind);
  }
  return found;
}

}  // namespace

void add_kinds(CLI::App& program, int& code) {
  struct KindsArguments {
    std::string kind;
    bool json = false, markdown = false;
  };
  auto arguments = std::make_shared<KindsArguments>();
  CLI::App* command = program.add_subcommand("kinds", "The kinds of component: all of them, or the page of one");
  command->add_option("kind", arguments->kind, "Name or the paper's name, e.g. DynamicMapRouter or AmDmr");
  command->add_flag("--json", arguments->json, "As data: ports, parameters, texts in both languages");
  command->add_flag("--markdown", arguments->markdown, "The manual's page on all kinds, docs/manual/kinds.md")
      ->excludes("--json");
  command->footer(
      "Examples:\n"
      "  ganglion kinds\n"
      "  ganglion kinds Escape\n"
      "  ganglion kinds AmDmr --language es\n"
      "  ganglion kinds --json\n"
      "Exit codes: 0 done, 2 there is no such kind.");
  command->callback([arguments, &code] {
    const auto found = matching(arguments->kind);
    if (found.empty()) {
      std::vector<std::string> names;
      for (const Descriptor* kind : every_kind()) names.emplace_back(kind->name);
      code = complain(Error{
          ErrorCode::UnknownKey,
          say({"\"{}\" is no kind{}", "\"{}\" no es un tipo{}"}, arguments->kind, suggestion(arguments->kind, names)),
          {},
          {.found = arguments->kind, .choices = names}});
    } else if (arguments->json) {
      fmt::print("{}", kinds_json(found));
    } else if (arguments->markdown) {
      fmt::print("{}", kinds_page(found, language()));
    } else if (arguments->kind.empty()) {
      code = list_kinds();
    } else {
      fmt::print("{}", kind_page(*found.front(), language()));
    }
  });
}

}  // namespace ganglion
