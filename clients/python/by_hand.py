# A robot in forty lines, from docs/link.md alone: a cart that drives towards a wall 3 m ahead, in lock-step.
import json, math, socket, sys

listener = socket.create_server(("127.0.0.1", int(sys.argv[1]) if sys.argv[1:] else 7007))
x_m, yaw_rad, tick, token = 0.0, 0.0, 0, "any text"
sensations = [{"name": name, "unit": "m", "min": 0.02, "max": 3} for name in ("sonar_left.range", "sonar_right.range")]
sensations.append({"name": "compass.heading", "unit": "rad", "type": "CIRCULAR"})
wheels = [{"name": name, "min": -1, "max": 1, "safe": 0} for name in ("left", "right")]
while True:
    connection = listener.accept()[0]

    def say(kind, **content):
        connection.sendall((json.dumps({kind: content}) + "\n").encode())

    for line in connection.makefile(errors="replace"):
        if not line.startswith("{"):
            break  # it speaks JSON only
        kind, content = next(iter(json.loads(line).items()))
        if kind == "hello":
            say("hello", major=1, token=token, last_tick=tick, resumed=content.get("token") == token)
            say("describe", name="Cart", tick_s=0.1, length_m=0.24, width_m=0.2, lock_step=True,
                sensations=sensations, commands=[{"name": "drive", "elements": wheels}])  # fmt: skip
        if kind == "reset":
            x_m, yaw_rad, tick = 0.0, 0.0, 0
            say("reset", **content)
        if kind == "act" and content.get("tick", 0) == tick:
            duties = [float(duty) for duty in content["values"]]
            left, right = (min(max(duty, -1), 1) if math.isfinite(duty) else 0 for duty in duties)
            moves_s = min(content.get("step_s", 0.1), content.get("ttl_ms", 300) / 1000)  # then it stands
            x_m += 0.2 * (left + right) / 2 * math.cos(yaw_rad) * moves_s
            yaw_rad = math.remainder(yaw_rad + 0.2 * (right - left) / 0.18 * moves_s, 2 * math.pi)
            tick += 1
        if kind == "beat" and not content.get("answer"):
            say("beat", number=content.get("number", 0), answer=True)
        if kind in ("hello", "reset", "act"):
            range_m = (3 - x_m) / math.cos(yaw_rad) if math.cos(yaw_rad) > 0.1 else math.inf
            say("sense", tick=tick, time_s=tick / 10, values=[range_m if range_m < 3 else "Infinity"] * 2 + [yaw_rad])
    connection.close()
