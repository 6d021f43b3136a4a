#include "ganglion/link/controller/examination.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/text.h"
#include "ganglion/link/controller/controller_end.h"
#include "ganglion/link/controller/robot_clock.h"
#include "ganglion/link/wire/description.h"

namespace ganglion::link {
namespace {

constexpr int kBeats = 10;
constexpr double kSlow_s = 0.1;

using Say = std::function<void(bool good, const Sentence& finding)>;

ControllerEndConfig watching(Carrier carrier, Encoding encoding, double patience_s) {
  ControllerEndConfig config;
  config.name = "ganglion doctor";
  config.carrier = carrier;
  config.encoding = encoding;
  config.role = wire::WATCH;
  config.truth = false;
  config.patience_s = patience_s;
  config.beat_s = 0.05;
  return config;
}

/// One look at one robot.
class Examination {
 public:
  Examination(std::unique_ptr<Line> line, const Say& say, const ExaminationOptions& options)
      : line_(std::move(line)), say_(say), options_(options), room_(kRoomBytes) {}

  bool run() {
    if (!reach()) return good_;
    describe();
    compare();
    first_frame();
    answers();
    end_->bye(say({"seen enough", "ya se miró lo suficiente"}));
    const auto sent = line_->send(end_->outgoing(), line_->now_s() + 1);
    static_cast<void>(sent);
    return good_;
  }

 private:
  void tell(bool good, const Sentence& finding) {
    good_ = good_ && good;
    say_(good, finding);
  }

  bool stopped() const { return options_.stop && options_.stop(); }
  double patience_end_s() const { return line_->now_s() + options_.patience_s; }

  bool reach() {
    const double until_s = line_->now_s() + options_.reach_s;
    auto reached = line_->connect(patience_end_s());
    while (!reached && line_->now_s() < until_s && !stopped()) {
      line_->wait_until(line_->now_s() + kRetry_s);
      reached = line_->connect(patience_end_s());
    }
    if (!reached) {
      tell(false, reached.error().what);
      return false;
    }
    tell(true, say({"{} takes connections", "{} acepta conexiones"}, line_->address()));
    if (greet(Encoding::Binary)) return true;
    const Sentence reason = end_->failure()->what;
    if (line_->carrier() == Carrier::Stream && line_->connect(patience_end_s()) && greet(Encoding::Json)) {
      tell(true, say({"it answers JSON lines but no binary frames: write encoding = \"json\" in [application]",
                      "responde líneas JSON, pero no tramas binarias: escriba encoding = \"json\" en [application]"}));
      return true;
    }
    tell(false, say({"no greeting came to its end: {}. It must answer Hello with Hello, Describe and Sense",
                     "ningún saludo llegó a su fin: {}. Debe responder a Hello con Hello, Describe y Sense"},
                    reason));
    return false;
  }

  bool greet(Encoding encoding) {
    end_.emplace(watching(line_->carrier(), encoding, options_.patience_s));
    end_->greet(line_->now_s());
    end_->connected(line_->now_s());
    while (!end_->done() && !end_->failure()) carry();
    if (end_->failure()) return false;
    tell(true, say({"it speaks protocol 1 and calls itself \"{}\"", "habla el protocolo 1 y se llama \"{}\""},
                   end_->robot_program()));
    return true;
  }

  void describe() {
    const wire::Describe& told = end_->describe();
    const auto robot = read_description(told);
    if (!robot) {
      return tell(false, say({"its description makes no sense: {}", "su descripción no tiene sentido: {}"},
                             robot.error().what));
    }
    description_ = *robot;
    Sentence size;
    if (robot->body) {
      size = say({", {} m long and {} m wide", ", de {} m de largo y {} m de ancho"}, shortest(robot->body->length_m),
                 shortest(robot->body->width_m));
    }
    tell(true,
         say({"it is \"{}\", {} robot{}{}, a tick each {} s", "es \"{}\", {} robot{}{}, un ciclo cada {} s"},
             robot->name, std::max(1u, told.robots()), told.robots() > 1 ? "s" : "", size, shortest(robot->tick_s)));
    std::vector<std::string> sensations, commands;
    for (const SensationChannel& channel : robot->sensations) {
      sensations.push_back(channel.name + (channel.unit.empty() ? "" : " [" + channel.unit + "]"));
    }
    for (const CommandChannel& channel : robot->commands) commands.push_back(channel.name);
    tell(!sensations.empty(), sensations.empty() ? say({"it senses nothing: fill in Describe.sensations",
                                                        "no percibe nada: complete Describe.sensations"})
                                                 : say({"it senses {}", "percibe {}"}, join(sensations)));
    tell(!commands.empty(), commands.empty()
                                ? say({"nothing can be commanded: fill in Describe.commands",
                                       "no admite mandos: complete Describe.commands"})
                                : say({"it takes the commands {}", "admite los mandos {}"}, join(commands)));
    tell_paces(told.lock_step(), told.free_running());
  }

  void tell_paces(bool lock_step, bool free_running) {
    if (!lock_step && !free_running) {
      return tell(false, say({"it can go at no pace: set lock_step or free_running in Describe",
                              "no puede ir a ningún ritmo: fije lock_step o free_running en Describe"}));
    }
    tell(true, lock_step && free_running
                   ? say({"it can go in lock-step and free-running", "puede ir paso a paso y a su propio ritmo"})
               : lock_step ? say({"it can go in lock-step", "puede ir paso a paso"})
                           : say({"it can go free-running", "puede ir a su propio ritmo"}));
  }

  /// With the robot the controller was drawn for.
  void compare() {
    const auto robots = static_cast<int>(std::max(1u, end_->describe().robots()));
    if (options_.robots > 0 && robots != options_.robots) {
      tell(false, say({"there are {} robots, the experiment has {}: set application.robots = {}",
                       "hay {} robots, el experimento tiene {}: fije application.robots = {}"},
                      robots, options_.robots, robots));
    }
    if (!description_ || options_.file == nullptr) return;
    const std::vector<Difference> found = differences(*options_.file, *description_);
    for (const Difference& one : found) {
      tell(!one.grave, one.grave ? say({"a controller for the robot file cannot drive it: {}",
                                        "un controlador hecho para el archivo del robot no puede conducirlo: {}"},
                                       text_of(one))
                                 : say({"it differs: {}", "difiere: {}"}, text_of(one)));
    }
    if (found.empty()) {
      tell(true,
           say({"it is the robot that the robot file describes", "es el robot que describe el archivo del robot"}));
    }
  }

  void first_frame() {
    if (!description_) return;
    const wire::Sense& sense = end_->sense();
    std::vector<SenseFrame> frames(std::max(1u, end_->describe().robots()), make_sense_frame(*description_));
    if (!read_senses(sense, frames)) {
      return tell(false, say({"its frames do not fit the description: of {} robots Sense must have {} values, and "
                              "{} ages or none",
                              "sus tramas no se ajustan a la descripción: de {} robots Sense debe tener {} valores, y "
                              "{} antigüedades o ninguna"},
                             frames.size(), frames.size() * frames.front().values.size(),
                             frames.size() * frames.front().ages_s.size()));
    }
    tell(true, say({"its frames fit the description; it is at tick {}",
                    "sus tramas se ajustan a la descripción; va por el ciclo {}"},
                   sense.tick()));
    for (const SenseFrame& frame : frames) check_values(frame);
    if (sense.tick() > 0 && told_time_s(sense) == 0) {
      tell(false,
           say({"it tells no time at tick {}: fill in Sense.time_s or time_ms, or no run can tell old readings "
                "from new ones",
                "no dice la hora en el ciclo {}: complete Sense.time_s o time_ms, o ninguna ejecución distinguirá "
                "lecturas viejas de nuevas"},
               sense.tick()));
    }
    clock_.start(told_time_s(sense));
    clock_tick_ = sense.tick();
    clock_s_ = line_->now_s();
  }

  /// Follows the clock of a robot that runs by itself.
  void watch_clock() {
    const wire::Sense& sense = end_->sense();
    if (!description_ || sense.tick() <= clock_tick_) return;
    const double now_s = line_->now_s(), due_s = (sense.tick() - clock_tick_) * description_->tick_s;
    const RobotClock::Step step = clock_.take(told_time_s(sense), due_s, now_s - clock_s_);
    clock_tick_ = sense.tick();
    clock_s_ = now_s;
    const bool good = step == RobotClock::Step::Regular || step == RobotClock::Step::Wrapped;
    if (!good && clock_.news()) tell(false, clock_.words(step));
  }

  void check_values(const SenseFrame& frame) {
    std::size_t n = 0;
    for (const SensationChannel& channel : description_->sensations) {
      for (int k = 0; k < channel.size(); ++k) {
        const double value = frame.values[n++];
        if (!std::isfinite(value) || (value >= channel.min && value <= channel.max)) continue;
        tell(false,
             say({"{} reads {}, outside of its own limits [{}, {}]", "{} da {}, fuera de sus propios límites [{}, {}]"},
                 channel.name, shortest(value), shortest(channel.min), shortest(channel.max)));
      }
    }
  }

  void answers() {
    std::vector<double> round_trips_s;
    const double until_s = patience_end_s();
    while (static_cast<int>(round_trips_s.size()) < kBeats && line_->now_s() < until_s && !end_->failure()) {
      const std::uint32_t before = end_->beats_answered();
      carry();
      watch_clock();
      if (end_->beats_answered() != before) round_trips_s.push_back(end_->statistics().round_trip_s);
    }
    if (round_trips_s.empty()) {
      return tell(false, say({"it answers no heartbeat: send every Beat back with answer = true and its number",
                              "no responde a los latidos: devuelva cada Beat con answer = true y su número"}));
    }
    std::sort(round_trips_s.begin(), round_trips_s.end());
    const double median_s = round_trips_s[round_trips_s.size() / 2];
    tell(median_s < kSlow_s,
         say({"it answers within {:.2f} ms (the slowest of {}: {:.2f} ms){}",
              "responde en {:.2f} ms (la más lenta de {}: {:.2f} ms){}"},
             median_s * 1e3, round_trips_s.size(), round_trips_s.back() * 1e3,
             median_s < kSlow_s ? Text{"", ""}
                                : Text{": too slow for a tick of 0.1 s", ": demasiado lento para un ciclo de 0.1 s"}));
    const auto lost = end_->statistics().lost;
    if (lost > 0) {
      tell(false,
           say({"{} damaged frames: check cable and baud rate", "{} tramas dañadas: revise el cable y la velocidad"},
               lost));
    }
  }

  /// Bytes there and back, for a moment.
  void carry() {
    if (stopped()) return end_->fail(say({"the look at it was ended", "se dejó de mirar"}));
    if (end_->wants_connection()) return end_->fail(say({"the connection broke", "se cortó la conexión"}));
    if (!end_->outgoing().empty()) {
      const bool sent = line_->send(end_->outgoing(), line_->now_s() + 1).has_value();
      end_->outgoing().clear();
      if (!sent) return end_->disconnected(line_->now_s());
    }
    const auto got = line_->receive(room_, std::min(end_->due_s(), line_->now_s() + 0.05));
    if (!got) return end_->disconnected(line_->now_s());
    if (*got > 0) end_->receive({room_.data(), *got}, line_->now_s());
    end_->poll(line_->now_s());
  }

  std::unique_ptr<Line> line_;
  std::optional<ControllerEnd> end_;
  const Say& say_;
  const ExaminationOptions& options_;
  std::vector<char> room_;
  std::optional<Description> description_;
  RobotClock clock_;
  std::uint32_t clock_tick_ = 0;
  double clock_s_ = 0;  // by our own, when its last Sense was looked at
  bool good_ = true;
};

}  // namespace

bool examine(std::unique_ptr<Line> line, const Say& say, const ExaminationOptions& options) {
  return Examination(std::move(line), say, options).run();
}

}  // namespace ganglion::link
