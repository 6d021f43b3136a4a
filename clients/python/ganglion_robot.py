"""The robot's end of the Ganglion link (docs/link.md, protocol 1.0) in one file: Python 3.11, standard library only.

Derive from Robot, say what it senses and how it drives, and serve() it:

    class Cart(Robot):
        def sense(self): return [self.range_m()]
        def act(self, values): self.set_motors(*values)

    Cart("robot.toml").serve("127.0.0.1", 7007)

It speaks JSON lines over TCP: `ganglion run EXPERIMENT --robot tcp://127.0.0.1:7007 --set application.encoding=json`.
Both paces: free-running always; lock-step where step() is defined, for simulations. It keeps the rules by itself: limits
and times to live of commands, one commander, any number of watchers, sessions that go on over a new connection. It looks
at the times to live after each frame and each piece of a frame, whoever sent it, and outlives what goes wrong in one.

Left out: binary frames (docs/link.md says how), Event, several robots behind one connection."""

import json
import math
import secrets
import select
import selectors
import socket
import sys
import time
import tomllib

MAX_FRAME, MAX_STRANGER, MAX_PENDING = 1 << 20, 4096, 1 << 20  # bytes
PIECE, TURN = 1 << 16, 64  # bytes that are read at once; frames that the commander gets in a turn, all others get one
REST_S = 0.002  # after a turn in which others spoke: who keeps a processor busy is made to wait for it when time is up
DEFAULT_TTL_S, MAX_TTL_S = 0.3, 0.5
HELLO_S, FREE_AFTER_S, SILENT_AFTER_S, LAST_WORD_S, MAX_STEP_S = 5.0, 1.0, 10.0, 1.0, 3600.0
VERSION, BUSY, BROKEN, TOO_SLOW, SHUTDOWN, NO_SESSION, REPLACED, REFUSED, TOO_MANY = range(1, 10)
MAX_CONNECTIONS = 32


class Broken(Exception):
    """The other side broke a rule, or asks for what cannot be: the code of Bye and the reason in words."""

    def __init__(self, reason: str, code: int = BROKEN):
        super().__init__(reason)
        self.code = code


def as_number(value) -> float:
    """A number of proto3's JSON: NaN and infinities are texts."""
    if isinstance(value, (int, float, str)) and not isinstance(value, bool):
        try:
            return float(value)
        except (ValueError, OverflowError):
            pass
    raise Broken(f"{str(value)[:40]!r} is no number")


def as_json(value: float):
    if math.isnan(value):
        return "NaN"
    return ("Infinity" if value > 0 else "-Infinity") if math.isinf(value) else value + 0.0


def as_count(value) -> int:
    """A whole number; those of 64 bits may come as texts."""
    if isinstance(value, str) and value.isdecimal() and len(value) <= 20:
        value = int(value)
    if not (isinstance(value, int) and not isinstance(value, bool)):
        number = as_number(value)
        value = int(number) if number.is_integer() else -1
    if not 0 <= value < 1 << 64:
        raise Broken(f"{str(value)[:40]!r} is no whole number >= 0")
    return value


def printable(text: str) -> str:
    return "".join(letter if letter.isprintable() else "?" for letter in text[:100])


def as_list(value) -> list[float]:
    if not isinstance(value, list):
        raise Broken(f"{str(value)[:40]!r} is no list of numbers")
    return [as_number(one) for one in value]


def describe(robot: dict) -> dict:
    """Describe, as the [[sensation]] and [[command]] tables of a robot.toml say."""
    sensations = []
    for table in robot.get("sensation", []):
        kept = ("name", "unit", "elements", "min", "max", "period_s", "x_m", "y_m")
        one = {key: table[key] for key in kept if key in table}
        one["type"] = table.get("type", "real").upper()
        one["yaw_rad"] = math.radians(table.get("yaw_deg", 0))
        sensations.append(one)
    commands = []
    for table in robot.get("command", []):
        names = table.get("elements", [table["name"]])
        presets = (("units", ""), ("min", -1), ("max", 1), ("safe", 0))
        rows = zip(names, *(table.get(key, [preset] * len(names)) for key, preset in presets), strict=True)
        elements = [dict(zip(("name", "unit", "min", "max", "safe"), row)) for row in rows]
        commands.append({"name": table["name"], "elements": elements})
    body = robot["body"]
    return {"name": robot["name"], "tick_s": robot.get("tick_s", 0.1), "length_m": body["length_m"],
            "width_m": body["width_m"], "sensations": sensations, "commands": commands}  # fmt: skip


class Connection:
    """Somebody who talks to the robot."""

    def __init__(self, stream: socket.socket, peer: str):
        self.stream, self.peer = stream, peer
        self.received, self.pending = bytearray(), bytearray()
        self.waiting = False  # a whole line was received and not yet looked at
        self.state = "new"  # then "commands" or "watches", and "closing"
        self.since = time.monotonic()  # it is new, or closing

    def say(self, kind: str, content: dict) -> None:
        if self.state == "watches" and len(self.pending) > MAX_PENDING // 16:
            return  # too slow for all
        self.pending += json.dumps({kind: content}, allow_nan=False).encode() + b"\n"

    def next_line(self) -> bytes | None:
        """None until more bytes have come."""
        if self.state == "closing" or not self.received:
            return None
        if self.state == "new" and self.received[0] != ord("{"):
            raise Broken('this robot speaks JSON lines only: begin with {"hello": {"major": 1}}, or let ganglion do so by '
                         '--set application.encoding=json')  # fmt: skip
        end = self.received.find(b"\n")
        if (end if end >= 0 else len(self.received)) > (MAX_FRAME if self.state == "commands" else MAX_STRANGER):
            raise Broken("a line is too long")
        if end < 0:
            return None
        line = bytes(self.received[:end])
        del self.received[: end + 1]
        return line


class Robot:
    """A robot that is described by a robot.toml. Its subclass senses and acts."""

    def sense(self) -> list[float]:
        """All values in the order of the file. NaN: no reading; inf: nothing in range; -inf: too close."""
        raise NotImplementedError

    def act(self, values: list[float]) -> None:
        """Drives: all command values in the order of the file, finite and within their limits."""
        raise NotImplementedError

    def step(self, step_s: float) -> None:
        """Lets time pass, in lock-step. Only a simulation can; it defines this."""
        raise NotImplementedError

    def reset(self, seed: int, episode: int) -> None:
        """Begins again. A real robot has nothing to do."""

    def ages_s(self) -> list[float]:
        """For each sensation the time since it was measured; none: all are fresh."""
        return []

    def log(self, text: str) -> None:
        """What happens, a line each. It must not wait: where nobody takes what is printed, it is dropped."""
        try:
            takes = select.select([], [sys.stdout], [], 0)[1]
        except (OSError, ValueError):  # no descriptor, or Windows
            takes = True
        try:
            print(text if takes else "", end="\n" if takes else "", flush=True)
        except (OSError, ValueError):  # closed, or letters it does not know
            pass

    def __init__(self, robot_file: str):
        with open(robot_file, "rb") as file:
            self.describe = describe(tomllib.load(file))
        self.lock_step = type(self).step is not Robot.step
        self.describe |= {"free_running": True, "lock_step": self.lock_step}
        self.tick_s = self.describe["tick_s"]
        self.channels = [[(one["min"], one["max"], one["safe"]) for one in command["elements"]]
                         for command in self.describe["commands"]]  # fmt: skip
        self.sensed = sum(len(one.get("elements", [0])) for one in self.describe["sensations"])
        self.tick, self.time_s, self.commands = 0, 0.0, []
        self.token, self.free_running, self.acted = "", False, -1
        self.until = [-math.inf] * len(self.channels)  # when each command runs out
        self.owner: Connection | None = None  # of the session
        self.commander, self.commanded, self.heard = "", False, -math.inf
        self.next_tick, self.noted = 0.0, -math.inf
        self.frames, self.bytes = 0, 0  # taken from others since the last look at the times to live
        self.most_frames, self.most_bytes = 0, 0  # ever between two looks
        self.connections: dict[socket.socket, Connection] = {}

    # -- what it does ------------------------------------------------------------------------------------------------

    def now_s(self) -> float:
        """The time that commands live in: the robot's in lock-step, else everybody's."""
        return time.monotonic() if self.free_running else self.time_s

    def take_safe_values(self, run_out_only: bool = False) -> None:
        now_s, at = self.now_s(), 0
        values = list(self.commands) or [0.0] * sum(map(len, self.channels))
        for n, limits in enumerate(self.channels):
            if not run_out_only or self.until[n] <= now_s:
                values[at : at + len(limits)] = [safe for _, _, safe in limits]
                self.until[n] = math.inf  # safe values hold for ever
            at += len(limits)
        if values != self.commands:
            self.drive(values)

    def drive(self, values: list[float]) -> None:
        self.commands = []  # nobody knows, should act() fail
        self.act(list(values))
        self.commands = values

    def carry_out(self, act: dict) -> None:
        values = as_list(act.get("values", []))
        limits = [one for channel in self.channels for one in channel]
        common_s = as_count(act.get("ttl_ms", 0)) / 1000 or DEFAULT_TTL_S
        ttl_s = as_list(act.get("ttl_s", [])) or [common_s] * len(self.channels)
        if len(values) != len(limits) or len(ttl_s) != len(self.channels):
            raise Broken(f"Act must have {len(limits)} values and, if any, {len(self.channels)} times to live")
        most_s = MAX_TTL_S if self.free_running else math.inf
        self.until = [self.now_s() + (min(one, most_s) if one > 0 else 0) for one in ttl_s]
        self.drive([min(max(value, low), high) if math.isfinite(value) else safe
                    for value, (low, high, safe) in zip(values, limits)])  # fmt: skip

    def pass_time(self, step_s: float) -> None:
        """Lock-step: commands run out in the middle of a long step."""
        end_s = self.time_s + step_s
        while (left_s := end_s - self.time_s) > 0:
            next_s = min([one for one in self.until if one > self.time_s] + [end_s])
            part_s = step_s if next_s >= end_s and left_s == step_s else min(left_s, next_s - self.time_s)
            self.step(part_s)
            self.time_s = end_s if next_s >= end_s else next_s
            self.take_safe_values(run_out_only=True)
        self.tick += 1

    def sense_frame(self) -> dict:
        values = [as_json(float(one)) for one in self.sense()]
        if len(values) != self.sensed:
            raise RuntimeError(f"sense() gave {len(values)} values, the robot file has {self.sensed}")
        frame = {"tick": self.tick, "time_s": self.time_s, "values": values}
        ages_s = [as_json(float(one)) for one in self.ages_s()]
        return frame | ({"ages_s": ages_s} if ages_s else {})

    def tell_sense(self, earlier: tuple | list = ()) -> None:
        """To all; the commander gets the ticks between, too."""
        frame = self.sense_frame()
        for one in self.connections.values():
            if one.state in ("commands", "watches"):
                one.say("sense", frame | ({"earlier": list(earlier)} if earlier and one is self.owner else {}))

    # -- who talks to it ---------------------------------------------------------------------------------------------

    def end_session(self, why: str) -> None:
        if self.token:
            self.log(f"{self.commander}: {why}")
        self.token, self.owner = "", None  # from now on each look takes the safe values, until act() did
        self.look()

    def refuse(self, one: Connection, code: int, reason: str) -> None:
        (self.note if one.state == "new" else self.log)(f"{one.peer}: closed: {reason}")
        ends = one is self.owner and code in (BROKEN, REFUSED, TOO_SLOW)
        if one.state != "closing":
            one.say("bye", {"code": code, "reason": reason})
        one.state, one.since = "closing", time.monotonic()
        if ends:
            self.end_session("the session is over")

    def note(self, text: str) -> None:
        """As log(), for what may come without end: a line per second."""
        if time.monotonic() - self.noted >= 1:
            self.noted = time.monotonic()
            self.log(text)

    def fail(self, error: Exception, one: Connection | None) -> None:
        """A mistake in sense(), act() or here ends a session, but not the program."""
        words = f"the robot's program failed: {printable(repr(error))}"
        self.note(words)
        if one is not None:
            self.refuse(one, REFUSED, words)

    def place_is_free(self) -> bool:
        if not self.token:
            return True
        patience_s = FREE_AFTER_S if self.owner is None or not self.commanded else SILENT_AFTER_S
        return time.monotonic() - self.heard >= patience_s

    def hello(self, one: Connection, hello: dict) -> None:
        if one.state != "new":
            raise Broken("Hello is said once")
        if as_count(hello.get("major", 0)) != 1:
            raise Broken(f"this robot speaks protocol 1.0, not {hello.get('major', 0)}", VERSION)
        watches = hello.get("role", 0) in (1, "WATCH")
        free_running = hello.get("pace", 0) in (1, "FREE_RUNNING")
        if not watches and not free_running and not self.lock_step:
            raise Broken("this robot cannot go in lock-step: ask for FREE_RUNNING", REFUSED)
        token = hello.get("token", "")
        if not watches:
            self.admit(one, printable(str(hello.get("name", ""))) or one.peer, token, free_running)
        one.state = "watches" if watches else "commands"
        one.say("hello", {"major": 1, "minor": 0, "token": "" if watches else self.token, "last_tick": self.tick,
                          "name": "ganglion_robot.py", "resumed": bool(token) and not watches})  # fmt: skip
        one.say("describe", self.describe)
        one.say("sense", self.sense_frame())

    def admit(self, one: Connection, name: str, token: str, free_running: bool) -> None:
        if token and token != self.token:
            raise Broken("that session is over: the robot was started again, or somebody else commands it", NO_SESSION)
        if not token and not self.place_is_free():
            raise Broken(f"{self.commander} commands this robot: watch, or come back later", BUSY)
        old, self.owner = self.owner, one
        if old is not None:
            self.refuse(old, REPLACED, "somebody else commands this robot now")
        if not token:
            self.take_safe_values()
            self.token, self.commander = secrets.token_hex(8), name
            self.free_running, self.acted, self.commanded = free_running, -1, False
            self.next_tick = time.monotonic() + self.tick_s
        self.heard = time.monotonic()
        self.log(f"{name} commands, {'free-running' if self.free_running else 'in lock-step'}")

    def command(self, one: Connection, kind: str, content: dict) -> None:
        self.commanded = True
        if kind == "reset":
            self.take_safe_values()
            self.reset(as_count(content.get("seed", 0)), as_count(content.get("episode", 0)))
            self.tick, self.time_s, self.acted = 0, 0.0, -1
            one.say("reset", {key: content[key] for key in ("seed", "episode") if key in content})
            return self.tell_sense()
        tick = as_count(content.get("tick", 0))
        if self.free_running:
            if kind == "step":
                raise Broken("Step is for lock-step")
            if tick > self.acted:
                self.carry_out(content)
                self.acted = tick
            return None
        if tick > self.tick:
            raise Broken(f"a command for tick {tick}, but the robot is at {self.tick}")
        if tick < self.tick:  # it was carried out, the answer got lost
            return one.say("sense", self.sense_frame())
        step_s = as_number(content.get("step_s", 0)) or self.tick_s
        ticks = as_count(content.get("ticks", 0)) if kind == "step" else 1
        if not (step_s > 0 and 1 <= ticks <= 1000 and ticks * step_s <= MAX_STEP_S):
            raise Broken(f"step_s must be above 0, ticks 1 to 1000, both together at most {MAX_STEP_S:g} s")
        if kind == "act":
            self.carry_out(content)
        earlier = []
        for n in range(ticks):
            self.pass_time(step_s)
            if n + 1 < ticks:
                earlier.append(self.sense_frame())
        return self.tell_sense(earlier)

    def handle(self, one: Connection, line: bytes) -> None:
        try:
            frame = json.loads(line)
        except (ValueError, RecursionError):
            raise Broken("a line is no JSON") from None
        if one.state == "new" and not (isinstance(frame, dict) and isinstance(frame.get("hello"), dict)):
            raise Broken("say Hello first")
        known = ("hello", "act", "step", "reset", "bye", "beat")
        kind = next((name for name in known if isinstance(frame, dict) and isinstance(frame.get(name), dict)), None)
        if kind is None:
            if isinstance(frame, dict) and not any(name in frame for name in known):
                return  # of a later version
            raise Broken('a line is no frame, such as {"act": {...}}')
        if kind == "hello":
            return self.hello(one, frame[kind])
        if kind == "bye":
            one.state, one.since = "closing", time.monotonic()
            return self.end_session("goodbye") if one is self.owner else None
        if kind == "beat":
            beat = frame[kind]
            if not beat.get("answer"):
                one.say("beat", {"number": as_count(beat.get("number", 0)), "answer": True, "time_s": time.monotonic()})
            return None
        if one is not self.owner:
            raise Broken("who watches sends no commands")
        return self.command(one, kind, frame[kind])

    # -- bytes and time ----------------------------------------------------------------------------------------------

    def look(self) -> None:
        """Commands that have run out, ticks: whatever is due is done."""
        self.most_frames, self.most_bytes = max(self.most_frames, self.frames), max(self.most_bytes, self.bytes)
        self.frames = self.bytes = 0
        try:
            if not self.token or self.free_running:
                self.take_safe_values(run_out_only=bool(self.token))
            if self.token and self.free_running and (now_s := time.monotonic()) >= self.next_tick:
                self.next_tick = max(self.next_tick + self.tick_s, now_s)
                self.tick += 1
                self.time_s = now_s
                self.tell_sense()
        except Exception as error:
            self.fail(error, self.owner)

    def wait_s(self) -> float:
        """How long until there is more to do, if nobody says anything."""
        if any(one.waiting for one in self.connections.values()):
            return 0.0
        due_s = [self.next_tick, *self.until] if self.token and self.free_running else []
        return max(0.0, min([time.monotonic() + 1.0, *due_s]) - time.monotonic())

    def receive(self, one: Connection) -> None:
        try:
            got = one.stream.recv(PIECE)
        except BlockingIOError:
            return
        except OSError:
            got = b""
        if not got:
            return self.lose(one)
        if one is self.owner:
            self.heard = time.monotonic()
        one.received += got
        self.bytes += len(got)
        self.look()

    def take_frame(self, one: Connection) -> bool:
        """False: there is none."""
        try:
            line = one.next_line()
            if line is None:
                return False
            self.frames += 1
            self.handle(one, line)
        except Broken as broken:
            self.refuse(one, broken.code, str(broken))
        except Exception as error:
            self.fail(error, one)
        self.look()
        return True

    def send(self, one: Connection) -> None:
        try:
            if one.pending:
                del one.pending[: one.stream.send(one.pending)]
        except BlockingIOError:
            pass
        except OSError:
            return self.lose(one)
        late = time.monotonic() - one.since > LAST_WORD_S
        if len(one.pending) > MAX_PENDING or (one.state == "closing" and (late or not one.pending)):
            return self.lose(one)
        wanted = selectors.EVENT_WRITE if one.pending else 0
        self.selector.modify(one.stream, wanted | (selectors.EVENT_READ if one.state != "closing" else 0))

    def lose(self, one: Connection) -> None:
        if self.connections.pop(one.stream, None) is None:
            return
        self.selector.unregister(one.stream)
        one.stream.close()
        one.state = "closing"
        if one is self.owner:
            self.owner = None
            self.heard = time.monotonic()
            self.log(f"{self.commander}: connection lost; safe values once its commands run out")

    def accept(self, listener: socket.socket) -> None:
        try:
            stream, peer = listener.accept()
            stream.setblocking(False)
            stream.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        except OSError:  # gone already, or no descriptors left
            return
        one = self.connections[stream] = Connection(stream, f"{peer[0]}:{peer[1]}")
        self.selector.register(stream, selectors.EVENT_READ)
        if len(self.connections) > MAX_CONNECTIONS:
            self.refuse(one, TOO_MANY, f"no more than {MAX_CONNECTIONS} connections; try again later")
            self.send(one)

    def turn(self, listener: socket.socket) -> None:
        """Waits until there is something to do. Then who commands comes first, and everybody a little."""
        for one in list(self.connections.values()):
            if one.state == "new" and time.monotonic() - one.since > HELLO_S:
                self.refuse(one, TOO_SLOW, f"no Hello within {HELLO_S:g} s")
            self.send(one)
        ready = {key.fileobj for key, events in self.selector.select(self.wait_s()) if events & selectors.EVENT_READ}
        self.look()
        others = listener in ready
        if others:
            self.accept(listener)
        for one in sorted(self.connections.values(), key=lambda one: one is not self.owner):
            others = others or (one is not self.owner and (one.waiting or one.stream in ready))
            if one.stream in ready and not one.waiting:
                self.receive(one)
            for _ in range(TURN if one is self.owner else 1):
                if not self.take_frame(one):
                    break
            one.waiting = one.state != "closing" and b"\n" in one.received
        if others and self.token:
            time.sleep(REST_S)

    def serve(self, host: str = "127.0.0.1", port: int = 7007) -> None:
        """Until ctrl-C. Port 0 takes any free one; either way the port is printed."""
        self.selector = selectors.DefaultSelector()
        with socket.create_server((host, port)) as listener:
            listener.setblocking(False)
            self.selector.register(listener, selectors.EVENT_READ)
            self.look()
            self.log(f"{self.describe['name']} listens at tcp://{host}:{listener.getsockname()[1]}")
            try:
                while True:
                    try:
                        self.turn(listener)
                    except Exception as error:
                        self.fail(error, None)
            except KeyboardInterrupt:
                self.log("ended")
            finally:
                self.end_session("the robot's program ends")
                for one in list(self.connections.values()):
                    self.refuse(one, SHUTDOWN, "the robot's program ends")
                    self.send(one)
                    self.lose(one)
                self.selector.close()
