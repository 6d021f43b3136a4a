#include "language.h"

#include <array>
#include <cstdlib>
#include <optional>
#include <regex>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

constexpr const char* kOption = "--language";

Language spoken_language = Language::English;

Language language_of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') continue;
    return std::string_view(value).starts_with("es") ? Language::Spanish : Language::English;
  }
  return Language::English;
}

/// What CLI11 says, as a pattern, and how we say it. The first that matches counts.
struct Refusal {
  const char* english;
  const char* spanish;
};
constexpr auto kRefusals = std::to_array<Refusal>({
    {"The following arguments? w(?:as|ere) not expected: (.*)", "no se esperaba: $1"},
    {"Could not convert: (.*)", "no se entiende el valor: $1"},
    {"(.*): Value (.*) not in range (.*) to (.*)", "$1: $2 no está entre $3 y $4"},
    {"(.*): (.*) not in (.*)", "$1: $2 no está entre $3"},
    {"(.*): At [Mm]ost (.*) required but received (.*)", "$1: admite $2 como máximo, se dieron $3"},
    {"(.*): At [Ll]east (.*) required but received (.*)", "$1: pide $2 como mínimo, se dieron $3"},
    {"(.*): (.*) required (.*) missing", "$1: faltan valores, $2 de tipo $3"},
    {"A subcommand is required", "falta un subcomando"},
    {"(.*) is required", "falta $1"},
    {"(.*) requires (.*)", "$1 necesita $2"},
    {"(.*) excludes (.*)", "$1 no va con $2"},
});

std::string spanish(const CLI::Error& error) {
  const std::string words = printable(error.what());
  for (const Refusal& one : kRefusals) {
    std::smatch found;
    if (std::regex_match(words, found, std::regex(one.english))) return found.format(one.spanish);
  }
  return "no se entiende la línea de órdenes: " + words;
}

/// The word that stands where a subcommand should, where one is missing, and the subcommand that it may mean.
std::optional<Sentence> unknown_command(const CLI::App* app, const CLI::Error& error) {
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  const std::vector<std::string> words = app->remaining();
  if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::RequiredError) || words.empty()) return std::nullopt;
  std::vector<std::string> names;
  for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  const std::string word = printable(words.front());
  if (names.empty() || word.starts_with('-')) return std::nullopt;
  return say({"there is no command \"{}\"{}", "no existe la orden \"{}\"{}"}, word, suggestion(word, names));
}

}  // namespace

Language language() noexcept { return spoken_language; }

void choose_language(int argc, const char* const* argv) {
  spoken_language = language_of_environment();
  const std::string joined = std::string(kOption) + "=";
  for (int i = 1; i < argc; ++i) {
    std::string_view value = argv[i];
    if (value == "--") return;
    if (value == kOption && i + 1 < argc) {
      value = argv[i + 1];
    } else if (value.starts_with(joined)) {
      value.remove_prefix(joined.size());
    } else {
      continue;
    }
    if (value == "en") spoken_language = Language::English;
    if (value == "es") spoken_language = Language::Spanish;
  }
}

void offer_languages(CLI::App& app) {
  app.add_option_function<std::string>(
         kOption, [](const std::string&) { /* choose_language() took it */ },
         "Of what is said, drawn and reported: en or es; default: as LC_ALL, LC_MESSAGES or LANG say")
      ->check(CLI::IsMember({"en", "es"}))
      ->take_last();
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) offer_languages(*command);
}

std::string refusal(const CLI::App* app, const CLI::Error& error) {
  const auto unknown = unknown_command(app, error);
  if (language() == Language::Spanish)
    return (unknown ? unknown->es : spanish(error)) + "\nCon --help hay más información.\n";
  return unknown ? unknown->en + "\nRun with --help for more information.\n" : CLI::FailureMessage::simple(app, error);
}

}  // namespace ganglion
