#pragma once

#include <CLI/CLI.hpp>

#include "ganglion/base/sentence.h"

namespace ganglion {

/// What the program speaks with its user: before choose_language() English.
Language language() noexcept;

/// Takes the last --language of a command line, as it stands: before it is parsed, since refusing it takes words as
/// well. Without one the first of LC_ALL, LC_MESSAGES and LANG that is set: what starts with "es" is Spanish.
void choose_language(int argc, const char* const* argv);

/// Has the program and all its subcommands take --language, before or behind their names.
void offer_languages(CLI::App& app);

/// Why a command line was refused, in the user's language. English is CLI11's own.
std::string refusal(const CLI::App* app, const CLI::Error& error);

}  // namespace ganglion
