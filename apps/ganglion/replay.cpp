#include <cstdio>

#include "commands.h"
#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/run/replay.h"
#include "ganglion/run/replay_open_loop.h"
#include "say.h"

namespace ganglion {
namespace {

int replay_recorded(const std::string& file) {
  const auto result = replay_run(file);
  if (!result) return complain(result.error());
  for (const Sentence& damage : result->damages) note(say({"damaged: {}", "dañado: {}"}, damage));
  if (result->same) {
    tell({"same: digest {}", "igual: huella {}"}, result->digest);
    return kDone;
  }
  tell({"differs: recorded digest {}, repeated {}", "difiere: huella registrada {}, repetida {}"},
       result->recorded_digest, result->digest);
  if (result->first_tick) {
    tell({"first at tick {}, signal {}: recorded {}, repeated {}",
          "por primera vez en el ciclo {}, señal {}: registrado {}, repetido {}"},
         *result->first_tick, result->signal, shortest(result->recorded_value), shortest(result->value));
  }
  return kRobotFailed;
}

int replay_csv(const std::string& controller, const std::string& inputs, const std::string& out) {
  Problems problems;
  const auto text = replay_open_loop(controller, inputs, problems);
  if (!text) return complain(problems);
  for (const Problems::Note& one : problems.notes()) note(one.text());
  if (const auto written = write_file(out, *text); !written) {
    complain(written.error());
    return kOutputFailed;
  }
  return kDone;
}

}  // namespace

void add_replay(CLI::App& program, int& code) {
  struct ReplayArguments {
    std::string file, inputs, out;
  };
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command =
      program.add_subcommand("replay", "Repeat a recorded run and compare, or feed a controller from a table");
  command->add_option("file", arguments->file, "A run file (.mcap), or a controller.toml")->required();
  auto* inputs = command->add_option("--inputs", arguments->inputs, "Table of sensations (CSV) for a controller");
  auto* out = command->add_option("--out", arguments->out, "Table of commands to write (CSV)");
  inputs->needs(out);
  out->needs(inputs);
  command->footer(
      "Examples:\n"
      "  ganglion replay runs/nimrod/seed_0001.mcap\n"
      "  ganglion replay experiments/nimrod/controller.toml --inputs in.csv --out out.csv\n"
      "Exit codes: 0 same, 1 differs, 2 bad input.");
  command->callback([arguments, &code] {
    const bool controller = arguments->file.ends_with(".toml");
    if (controller && arguments->inputs.empty()) {
      code = complain(Error{ErrorCode::MissingKey, say({"a controller needs --inputs IN.csv --out OUT.csv",
                                                        "un controlador necesita --inputs IN.csv --out OUT.csv"})});
    } else if (controller) {
      code = replay_csv(arguments->file, arguments->inputs, arguments->out);
    } else {
      code = replay_recorded(arguments->file);
    }
  });
}

}  // namespace ganglion
