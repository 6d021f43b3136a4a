#include <cstdio>

#include "commands.h"
#include "ganglion/link/net/proxy.h"
#include "interrupt.h"
#include "reachable.h"
#include "say.h"

namespace ganglion {
namespace {

struct ProxyArguments {
  std::string listen = "127.0.0.1:7008";
  std::string to = "127.0.0.1:7007";
  std::string faults;
  std::uint64_t seed = 0;
  bool quiet = false;
};

Result<link::LineFaults> faults_of(const ProxyArguments& arguments) {
  if (arguments.faults == "drawn") return link::drawn_line_faults(arguments.seed, link::Hardness::Mendable);
  if (arguments.faults == "drawn_any") return link::drawn_line_faults(arguments.seed, link::Hardness::Any);
  return link::parse_line_faults(arguments.faults);
}

int proxy_command(const ProxyArguments& arguments) {
  const auto listen = link::parse_address(arguments.listen);
  if (!listen) return complain(listen.error());
  const auto to = link::parse_address(arguments.to);
  if (!to) return complain(to.error());
  auto faults = faults_of(arguments);
  if (!faults) return complain(faults.error());
  const std::string text = text_of(*faults);
  link::ProxyConfig config{*listen, *to, std::move(*faults), arguments.seed, nullptr};
  if (!arguments.quiet) config.log = note;
  auto proxy = link::Proxy::listen(std::move(config));
  if (!proxy) return complain(proxy.error());
  catch_interrupts();
  tell({"from {} to {} with --faults \"{}\" --seed {}; end it with ctrl-C",
        "de {} a {} con --faults \"{}\" --seed {}; termínelo con ctrl-C"},
       (*proxy)->address().text, to->text, text, arguments.seed);
  note_who_reaches((*proxy)->address());
  std::fflush(stdout);
  (*proxy)->serve([] { return interrupted(); });
  return kDone;
}

}  // namespace

void add_proxy(CLI::App& program, int& code) {
  auto arguments = std::make_shared<ProxyArguments>();
  CLI::App* command = program.add_subcommand("proxy", "Stand between a controller and a robot, and spoil the line");
  command->add_option("--listen", arguments->listen, "HOST:PORT for controllers; port 0 takes a free one")
      ->capture_default_str();
  command->add_option("--to", arguments->to, "HOST:PORT of the robot")->capture_default_str();
  command->add_option("--faults", arguments->faults,
                      "What goes wrong, as below; or drawn, drawn_any: a schedule drawn from the seed");
  command->add_option("--seed", arguments->seed, "Seed of every decision")->capture_default_str();
  command->add_flag("--quiet", arguments->quiet, "Say nothing of who comes and goes");
  command->footer(
      "Faults stand between \";\", what belongs to one between \",\":\n"
      "  delay=20ms jitter=5ms       each frame takes so long, and up to so much longer\n"
      "  loss=1% duplicate=1%        shares of the frames that vanish, or arrive twice\n"
      "  merge=10% split=10%         ... that arrive together with the next, or in pieces\n"
      "  corrupt=0.001               share of the bytes in which a bit is changed\n"
      "  fin=1% rst=1%               shares of the frames within which the connection ends, in order or at once\n"
      "  mute                        everything vanishes, and nobody is told (half-open)\n"
      "  freeze                      nothing arrives until the end of it\n"
      "  from=4s until=6s            when; from the first connection\n"
      "  to=robot|controller|both    which way\n"
      "Examples:\n"
      "  ganglion proxy --faults \"delay=20ms,jitter=5ms,loss=1%\" --seed 7\n"
      "  ganglion proxy --faults \"freeze,from=4s,until=6s; mute,to=robot,from=9s,until=10s\"\n"
      "  ganglion run experiments/nimrod --robot tcp://127.0.0.1:7008      (in another terminal)\n"
      "Exit codes: 0 ended, 2 bad input, 3 the address cannot be used.");
  command->callback([arguments, &code] { code = proxy_command(*arguments); });
}

}  // namespace ganglion
