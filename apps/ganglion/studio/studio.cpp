#include "ganglion/studio/server/server.h"

#include <spawn.h>
#include <unistd.h>

#include <cstdio>
#include <thread>

#include "commands.h"
#include "ganglion/base/text.h"
#include "ganglion/studio/api/programs.h"
#include "interrupt.h"
#include "say.h"
#include "studio/studio.h"

extern char** environ;

namespace ganglion {
namespace {

struct StudioArguments {
  std::string folder = ".";
  std::string listen = "127.0.0.1";
  std::vector<std::string> allow_hosts;
  std::string web_root;
  bool no_browser = false;
};

/// "127.0.0.1:8745", "[::1]:8745", or an address alone.
Result<void> read_listen(const std::string& text, studio::ServerOptions& options) {
  const std::size_t colon = text.rfind(':');
  const bool bare_v6 = !text.starts_with('[') && text.find(':') != colon;
  options.address = text;
  if (colon != std::string::npos && !bare_v6 && text.back() != ']') {
    const auto port = parse_number(std::string_view(text).substr(colon + 1));
    if (!port || *port < 0 || *port > 65535 || *port != static_cast<int>(*port)) {
      return fail(ErrorCode::BadParameter,
                  {"--listen {}: write ADDRESS:PORT, as in 127.0.0.1:8745",
                   "--listen {}: escriba DIRECCIÓN:PUERTO, como 127.0.0.1:8745"},
                  text);
    }
    options.port = static_cast<std::uint16_t>(*port);
    options.address = text.substr(0, colon);
  }
  if (options.address.starts_with('[') && options.address.ends_with(']')) {
    options.address = options.address.substr(1, options.address.size() - 2);
  }
  if (options.address == "localhost") options.address = "127.0.0.1";
  return {};
}

int serve(const StudioArguments& arguments) {
  studio::ServerOptions options;
  options.folder = arguments.folder;
  options.allow_hosts = arguments.allow_hosts;
  options.web_root = arguments.web_root;
  options.programs = studio::programs_file();
  if (auto read = read_listen(arguments.listen, options); !read) return complain(read.error());
  const auto server = studio::Server::start(options);
  if (!server) return complain(server.error());
  announce_studio(**server, !arguments.no_browser);
  if (!arguments.allow_hosts.empty()) {
    note(say({"Warning: other machines can reach this server; whoever has the URL can edit and run.",
              "Aviso: otras máquinas pueden llegar a este servidor; quien tenga la URL puede editar y ejecutar."}));
  }
  catch_interrupts();
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return kDone;
}

}  // namespace

void announce_studio(const studio::Server& server, bool browser) {
  const std::string url = server.url();
  fmt::print("{}\n", url);
  std::fflush(stdout);
  const bool display = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
  if (!browser || !display) return;
  std::string opener = "xdg-open", address = url;
  char* words[] = {opener.data(), address.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "xdg-open", nullptr, nullptr, words, environ) != 0) {
    note(say({"No browser could be opened: open the URL above.",
              "No se pudo abrir ningún navegador: abra la URL de arriba."}));
  }
}

void add_studio(CLI::App& program, int& code) {
  auto arguments = std::make_shared<StudioArguments>();
  CLI::App* command = program.add_subcommand("studio", "Draw, run, watch and replay in a browser");
  command->add_option("folder", arguments->folder, "What the studio may read and write; default: this folder");
  command->add_option("--listen", arguments->listen, "ADDRESS:PORT; default: 127.0.0.1 and any free port");
  command
      ->add_option("--allow-host", arguments->allow_hosts,
                   "A name by which browsers of other machines ask; needed to listen on other addresses")
      ->allow_extra_args(false);
  command->add_option("--web-root", arguments->web_root, "Serve the page's files from this folder, to develop them");
  command->add_flag("--no-browser", arguments->no_browser, "Only print the URL");
  command->footer(
      "Examples:\n"
      "  ganglion studio experiments\n"
      "  ganglion studio experiments --listen 127.0.0.1:8745 --no-browser\n"
      "The URL holds the key: who has it may edit and run. Programs that the page may start are listed in\n"
      "~/.config/ganglion/studio.toml: [[program]] name = \"my robot\", command = [\"/path/to/program\", \"{port}\"].");
  command->callback([arguments, &code] { code = serve(*arguments); });
}

}  // namespace ganglion
