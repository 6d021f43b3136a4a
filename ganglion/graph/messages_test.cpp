#include <gtest/gtest.h>

#include "ganglion/graph/testing/example_files.h"

// What a person reads who makes one mistake in a good file. Each message says where, what was found and what would have
// been right; nothing that merely follows from the mistake is reported on top of it.
namespace ganglion {
namespace {

using example::complaints, example::kArbiter;

/// kArbiter with the first `from` replaced.
std::string with(std::string_view from, std::string_view to) {
  std::string text = kArbiter;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

struct Mistake {
  const char* name;
  const char* from;
  const char* to;
  const char* told;
};

void expect_told(std::span<const Mistake> mistakes) {
  for (const Mistake& mistake : mistakes) {
    EXPECT_EQ(complaints(with(mistake.from, mistake.to)), std::string(mistake.told) + "\n") << mistake.name;
  }
}

constexpr const char* kLeft = "in.left = \"sonar_left\"";

TEST(Messages, AreNoneForGoodFiles) {
  EXPECT_EQ(complaints(kArbiter), "");
  EXPECT_EQ(complaints(example::kBehaviour), "");
  EXPECT_EQ(complaints(example::kLoops), "");
}

TEST(Messages, OfKeysAndKinds) {
  constexpr Mistake kMistakes[] = {
      {"unknown key", "trigger_range_m", "triger_range_m",
       "c.toml:32:18: back_off: \"triger_range_m\" is no key here; did you mean \"trigger_range_m\"?"},
      {"unknown key of the file", "name =", "nam =", "c.toml:2:7: \"nam\" is no key here; did you mean \"name\"?"},
      {"unknown class", "[[goal]]", "[[goals]]", "c.toml:22:1: \"goals\" is no key here; did you mean \"goal\"?"},
      {"table instead of list", "[[goal]]", "[goal]", "c.toml:22:1: goal is a table, must be written as [[goal]]"},
      {"misspelt kind", "\"BackOff\"", "\"BackOf\"",
       "c.toml:29:8: back_off: \"BackOf\" is no kind of acting module; did you mean \"BackOff\"?"},
      {"unknown kind", "\"BackOff\"", "\"Zigzag\"",
       "c.toml:29:8: back_off: \"Zigzag\" is no kind of acting module; valid: BackOff, GoTo"},
      {"kind of another class", "\"BackOff\"", "\"Nearest\"",
       "c.toml:29:8: back_off: \"Nearest\" is a kind of sensing module; write it under [[sensing]], not [[acting]]"},
      {"missing kind", "kind = \"BackOff\"\n", "", "c.toml:27:1: back_off: kind is missing; valid: BackOff, GoTo"},
      {"missing id", "id = \"go\"\n", "", "c.toml:34:1: id is missing; write id = \"a_name\""},
      {"bad id", "id = \"nearest\"", "id = \"the nearest\"",
       "c.toml:18:6: \"the nearest\" is no id: write a letter, then letters, digits or _, at most 64 in all"},
      {"duplicate id", "id = \"nearest\"", "id = \"position\"",
       "c.toml:18:6: position: this id is already used at line 14"},
      {"missing format", "format = 1\n", "", "c.toml:1:1: the file must start with format = 1"},
      {"newer format", "format = 1", "format = 2",
       "c.toml:1:10: this program reads format = 1; the file needs a newer program"},
      {"no format of ours", "format = 1", "format = 0", "c.toml:1:10: format is 0, must be 1"},
  };
  expect_told(kMistakes);
}

TEST(Messages, OfValues) {
  constexpr Mistake kMistakes[] = {
      {"text for a number", "0.2", "\"0.2\"", "c.toml:32:19: back_off: trigger_range_m is a text, must be a number"},
      {"out of range", "0.2", "5", "c.toml:32:19: back_off: trigger_range_m is 5, must be in [0, 3]"},
      {"not finite", "0.2", "nan", "c.toml:32:19: back_off: trigger_range_m is nan, must be in [0, 3]"},
      {"bad choice", "trigger_range_m = 0.2", "side = \"lefft\"",
       "c.toml:32:8: back_off: side is \"lefft\"; did you mean \"left\"?"},
      {"unknown choice", "trigger_range_m = 0.2", "side = \"upwards\"",
       "c.toml:32:8: back_off: side is \"upwards\"; valid: left, right, freer"},
      {"not whole", "at_m = [1, 2]", "priority_class = 1.5",
       "c.toml:25:18: charger: priority_class is a number, must be a whole number"},
      {"number for a switch", "trigger_range_m = 0.2", "loud = 1",
       "c.toml:32:8: back_off: loud is a whole number, must be true or false"},
      {"too many items", "[1, 2]", "[1, 2, 3]", "c.toml:25:8: charger: at_m has 3 numbers, must have 2"},
      {"item of another type", "[1, 2]", "[1, \"2\"]", "c.toml:25:12: charger: at_m is a text, must be a number"},
      {"a date", "0.2", "2024-01-01",
       "c.toml:32:19: dates and times are not used here; write a number or a text in quotes"},
  };
  expect_told(kMistakes);
}

TEST(Messages, OfWires) {
  const Mistake mistakes[] = {
      {"misspelt sensation", kLeft, "in.left = \"sonar_lft\"",
       "c.toml:30:11: back_off: \"sonar_lft\" is no sensation or module; did you mean \"sonar_left\"?"},
      {"unknown sensation", kLeft, "in.left = \"camera\"",
       "c.toml:30:11: back_off: \"camera\" is no sensation or module; valid: sonar_left, sonar_right, position.x, "
       "position.y, nearest.range, go.expected"},
      {"misspelt module", kLeft, "in.left = \"nearst.range\"",
       "c.toml:30:11: back_off: \"nearst\" is no sensation or module; did you mean \"nearest.range\"?"},
      {"channel instead of sensation", kLeft, "in.left = \"sonar_left.range\"",
       "c.toml:30:11: back_off: \"sonar_left.range\" is a channel of the robot; wire the sensation that reads it: "
       "\"sonar_left\""},
      {"channel nobody reads", kLeft, "in.left = \"compass.heading\"",
       "c.toml:30:11: back_off: \"compass.heading\" is a channel of the robot; add a [[sensation]] with channel = "
       "\"compass.heading\" and wire its id"},
      {"empty channel", "\"sonar_left.range\"", "\"\"",
       "c.toml:7:11: sonar_left: channel is empty; name a channel of the robot"},
      {"misspelt channel", "\"sonar_left.range\"", "\"sonar_left.rang\"",
       "c.toml:7:11: sonar_left: the robot has no channel \"sonar_left.rang\"; did you mean \"sonar_left.range\"?"},
      {"misspelt port", "in.left", "in.lft",
       "c.toml:30:10: back_off: BackOff has no input \"lft\"; did you mean \"left\"?"},
      {"port without in", "in.left", "left", "c.toml:30:8: back_off: \"left\" is an input; write in.left = \"...\""},
      {"missing port", "in.right = \"sonar_right\"\n", "",
       "c.toml:28:6: back_off: input \"right\" is not wired; write in.right = \"...\""},
      {"port with nothing on it", "in.right = \"sonar_right\"", "in.right = []",
       "c.toml:28:6: back_off: input \"right\" is not wired; write in.right = \"...\""},
      {"other unit", kLeft, "in.left = \"nearest.bearing\"",
       "c.toml:30:11: back_off: input \"left\" is in [m], \"nearest.bearing\" is in [rad]; valid: sonar_left, "
       "sonar_right, position.x, position.y, nearest.range, go.expected"},
      {"too few values", "in.position = \"position\"", "in.position = \"sonar_left\"",
       "c.toml:38:15: go: input \"position\" takes 2 values {x, y}, \"sonar_left\" has 1"},
      {"too many values", kLeft, "in.left = \"position\"",
       "c.toml:30:11: back_off: input \"left\" takes 1 value, \"position\" has 2; valid: position.x, position.y"},
      {"too many wires", kLeft, "in.left = [\"sonar_left\", \"sonar_right\"]",
       "c.toml:30:11: back_off: input \"left\" takes one wire, not 2"},
      {"one of several outputs", kLeft, "in.left = \"nearest\"",
       "c.toml:30:11: back_off: \"nearest\" has several outputs; say which; valid: nearest.range, nearest.bearing"},
      {"misspelt output", kLeft, "in.left = \"nearest.rang\"",
       "c.toml:30:11: back_off: \"nearest\" has no output \"rang\"; did you mean \"range\"?"},
      {"misspelt element", kLeft, "in.left = \"position.z\"",
       "c.toml:30:11: back_off: sensation \"position\" has no \"z\"; did you mean \"x\"?"},
      {"part of one value", kLeft, "in.left = \"sonar_left.x\"",
       "c.toml:30:11: back_off: \"sonar_left\" is one value; write \"sonar_left\", or \"sonar_left.age_s\" for its "
       "age"},
      {"dangling mark", kLeft, "in.left = \"sonar_left@prev\"",
       "c.toml:30:11: back_off: \"sonar_left@prev\": the only mark is @previous, as in \"sonar_left@previous\""},
      {"a goal's values", kLeft, "in.left = \"charger\"",
       "c.toml:30:11: back_off: \"charger\" has several outputs; say which; valid: charger.intensity, charger.holds, "
       "charger.rests_s"},
      {"circle", "[\"sonar_left\", \"sonar_right\"]", "[\"sonar_left\", \"nearest.range\"]",
       "c.toml:20:28: nearest: these wires run in a circle within one tick: nearest -> nearest; write "
       "\"nearest.range@previous\" to break it"},
      {"later in the tick", "[\"sonar_left\", \"sonar_right\"]", "[\"sonar_left\", \"go.expected\"]",
       "c.toml:20:28: nearest: \"go.expected\" is known only later in the tick; write \"go.expected@previous\""},
  };
  expect_told(mistakes);
}

TEST(Messages, OfCommandsAndRequests) {
  constexpr Mistake kMistakes[] = {
      {"two writers", "in.commands = [\"back_off\", \"go\"]\n",
       "in.commands = \"back_off\"\ncommand = \"drive\"\n[[coordinator]]\nid = \"second\"\nkind = \"First\"\n"
       "in.commands = [\"go\"]\n",
       "c.toml:49:11: second: \"arbiter\" already commands \"drive\"; join them by a coordinator"},
      {"writer below a coordinator", "trigger_range_m = 0.2", "command = \"drive\"",
       "c.toml:32:11: back_off: its command goes to \"arbiter\" already; leave out command = \"drive\""},
      {"two takers", "[[coordinator]]",
       "[[coordinator]]\nid = \"b\"\nkind = \"First\"\nin.commands = \"go\"\n"
       "command = \"drive\"\n[[coordinator]]",
       "c.toml:48:28: arbiter: the command of \"go\" already goes to \"b\"\n"
       "c.toml:49:11: arbiter: \"b\" already commands \"drive\"; join them by a coordinator"},
      {"command that goes nowhere", "command = \"drive\"\n", "",
       "c.toml:41:6: arbiter: its command goes nowhere; write command = \"...\" (the robot has: drive, arm) or wire it "
       "to a coordinator"},
      {"unknown command", "\"drive\"", "\"drve\"",
       "c.toml:44:11: arbiter: the robot has no command \"drve\"; did you mean \"drive\"?"},
      {"command of another shape", "in.commands = [\"back_off\", \"go\"]",
       "in.commands = \"back_off\"\n[[acting]]\nid = \"lift\"\nkind = \"BackOff\"\nin = {left = \"sonar_left\", right "
       "= "
       "\"sonar_left\"}\ncommand = \"arm\"\n[[coordinator]]\nid = \"other\"\nkind = \"First\"\nin.commands = \"go\"",
       "c.toml:41:6: arbiter: its command goes nowhere; write command = \"...\" (the robot has: drive, arm) or wire it "
       "to a coordinator\n"
       "c.toml:48:11: lift: commands {left, right} but \"arm\" takes {lift}"},
      {"misspelt candidate", "\"go\"]", "\"goo\"]",
       "c.toml:43:28: arbiter: \"goo\" is no acting module or coordinator; did you mean \"go\"?"},
      {"goal as candidate", "\"go\"]", "\"charger\"]",
       "c.toml:43:28: arbiter: \"charger\" is no acting module or coordinator; valid: back_off, go, arbiter"},
      {"sensation as request", "in.request = \"charger\"", "in.request = \"position\"",
       "c.toml:37:14: go: \"position\" is no goal or acting module; valid: charger, back_off, go, arbiter"},
      {"command of the last tick", "\"go\"]", "\"go@previous\"]",
       "c.toml:43:28: arbiter: a command is handed on within its tick; leave out @previous"},
      {"command not made yet", "\"sonar_right\"]", "\"drive.left\"]",
       "c.toml:20:28: nearest: the command of this tick is not made yet; write \"drive.left@previous\""},
      {"commands in a circle", "[\"back_off\", \"go\"]\ncommand = \"drive\"",
       "[\"back_off\", \"go\", \"second\"]\n[[coordinator]]\nid = \"second\"\nkind = \"First\"\nin.commands = "
       "\"arbiter\"",
       "c.toml:41:6: arbiter: these wires run in a circle within one tick: arbiter -> second -> arbiter; commands "
       "cannot; "
       "take one of these wires out"},
  };
  expect_told(kMistakes);
}

TEST(Messages, OfSyntax) {
  constexpr Mistake kMistakes[] = {
      {"open quote", "id = \"go\"", "id = \"go",
       "c.toml:35:9: not valid TOML: a text must be closed by its quote on the same line, and holds no control "
       "characters"},
      {"no quotes", "id = \"go\"", "id = go",
       "c.toml:35:6: not valid TOML: this is no value; texts stand in quotes, \"like this\""},
      {"no value", "id = \"go\"", "id =", "c.toml:35:5: not valid TOML: after = a value is missing"},
      {"no equals sign", "id = \"go\"", "id: \"go\"", "c.toml:35:3: not valid TOML: after a key come = and a value"},
      {"decimal comma", "0.2", "0,2",
       "c.toml:32:20: not valid TOML: one value a line; decimals have a point, as in 0.5"},
      {"unit behind a number", "0.2", "0.2m",
       "c.toml:32:22: not valid TOML: this is no number; write 12, 0.5 or 1e-3, without a unit"},
      {"capital letter", "0.2", "True", "c.toml:32:19: not valid TOML: write true or false, in small letters"},
      {"key given twice", "in.right", "in.left",
       "c.toml:31:11: not valid TOML: \"in.left\" was given above; each key and each [table] stands once"},
      {"no comma", "[1, 2]", "[1 2]",
       "c.toml:25:11: not valid TOML: the items of a list are separated by commas, and a ] closes it"},
      {"one bracket", "[[goal]]", "[[goal]",
       "c.toml:22:8: not valid TOML: a header is written [name] or [[name]], alone on its line"},
      {"foreign comment",
       "name =", "// name =", "c.toml:2:1: not valid TOML: a line starts with a key, a [header] or a # comment"},
  };
  expect_told(kMistakes);
}

TEST(Messages, ComeAllAtOnce) {
  std::string text = with("0.2", "5");
  text.replace(text.find("\"drive\""), 7, "\"drve\"");
  text.replace(text.find("\"sonar_right.range\""), 19, "\"sonar_rigt.range\"");
  EXPECT_EQ(complaints(text),
            "c.toml:11:11: sonar_right: the robot has no channel \"sonar_rigt.range\"; did you mean "
            "\"sonar_right.range\"?\n"
            "c.toml:32:19: back_off: trigger_range_m is 5, must be in [0, 3]\n"
            "c.toml:44:11: arbiter: the robot has no command \"drve\"; did you mean \"drive\"?\n");
}

}  // namespace
}  // namespace ganglion
