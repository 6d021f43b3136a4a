#!/usr/bin/env python3
"""describe.py ROBOT.toml [--lock-step] [--no-free-running] > describe.h

Writes what a robot.toml with [[sensation]] and [[command]] tables says as the constants a robot with ganglion_robot.c
keeps in flash: its Describe, ready to be sent, and its sizes and limits. Needs Python 3.11 and nothing else, or one from
3.8 on with the package tomli, which pip brings along."""

from __future__ import annotations

import argparse
import importlib
import math
import struct
import sys

TYPES = {"real": 0, "discrete": 1, "circular": 2}


def read_toml(path: str) -> dict:
    for name in ("tomllib", "tomli", "pip._vendor.tomli"):
        try:
            toml = importlib.import_module(name)
        except ImportError:
            continue
        with open(path, "rb") as file:
            return toml.load(file)
    sys.exit("describe.py: this Python %d.%d reads no TOML: use 3.11 or later, or install tomli: python3 -m pip install tomli"
             % sys.version_info[:2])  # fmt: skip


def varint(value: int) -> bytes:
    out = b""
    while value > 0x7F:
        out += bytes([value & 0x7F | 0x80])
        value >>= 7
    return out + bytes([value])


def number(field: int, value: int) -> bytes:
    return varint(field << 3) + varint(value) if value else b""


def double(field: int, value: float, optional: bool = False) -> bytes:
    return varint(field << 3 | 1) + struct.pack("<d", value) if value or optional else b""


def block(field: int, content: bytes | str) -> bytes:
    content = content.encode() if isinstance(content, str) else content
    return varint(field << 3 | 2) + varint(len(content)) + content


def text(field: int, content: str) -> bytes:
    return block(field, content) if content else b""


def sensation(table: dict) -> bytes:
    out = text(1, table["name"]) + text(2, table.get("unit", "")) + number(3, TYPES[table.get("type", "real")])
    out += b"".join(block(4, name) for name in table.get("elements", []))
    out += b"".join(double(n, table[key], True) for n, key in ((5, "min"), (6, "max")) if key in table)
    out += double(7, table.get("period_s", 0)) + double(8, table.get("x_m", 0)) + double(9, table.get("y_m", 0))
    return out + double(10, math.radians(table.get("yaw_deg", 0)))


def elements(table: dict) -> list[tuple]:
    """Name, unit, min, max, safe of each value of a command."""
    names = table.get("elements", [table["name"]])
    count = len(names)
    units = table.get("units", [""] * count)
    lists = [table.get(key, [preset] * count) for key, preset in (("min", -1), ("max", 1), ("safe", 0))]
    if any(len(one) != count for one in (units, *lists)):
        sys.exit(f'describe.py: command "{table["name"]}": units, min, max and safe need {count} values each')
    return list(zip(names, units, *lists))


def command(table: dict) -> bytes:
    parts = (
        text(1, name) + text(2, unit) + double(3, low) + double(4, high) + double(5, safe)
        for name, unit, low, high, safe in elements(table)
    )
    return text(1, table["name"]) + b"".join(block(2, part) for part in parts)


def describe(robot: dict, lock_step: bool, free_running: bool) -> bytes:
    out = text(1, robot["name"]) + double(3, robot.get("tick_s", 0.1))
    out += double(4, robot["body"]["length_m"]) + double(5, robot["body"]["width_m"])
    out += b"".join(block(6, sensation(table)) for table in robot.get("sensation", []))
    out += b"".join(block(7, command(table)) for table in robot.get("command", []))
    return block(2, out + number(8, lock_step) + number(9, free_running))


def packet(frame: bytes) -> bytes:
    """COBS of the frame and its CRC between zeros: that which goes ahead ends what was printed on the line before."""
    crc = 0xFFFF
    for byte in frame:
        crc ^= byte << 8
        for _ in range(8):
            crc = (crc << 1 ^ (0x1021 if crc & 0x8000 else 0)) & 0xFFFF
    out = b"\0"
    for piece in (frame + crc.to_bytes(2, "big")).split(b"\0"):
        while len(piece) >= 254:
            out += b"\xff" + piece[:254]
            piece = piece[254:]
        out += bytes([len(piece) + 1]) + piece
    return out + b"\0"


def table_of(content: bytes) -> str:
    lines = (", ".join(f"0x{byte:02x}" for byte in content[n : n + 16]) for n in range(0, len(content), 16))
    return "static const uint8_t kDescribe[] = {\n  " + ",\n  ".join(lines) + "};"


def as_float(value: float) -> str:
    return f"{float(value)!r}F"


def header(robot: dict, frame: bytes, free_running: bool) -> str:
    limits = [one for table in robot.get("command", []) for one in elements(table)]
    values = sum(len(table.get("elements", [0])) for table in robot.get("sensation", []))
    rows = ",\n  ".join("{%s, %s, %s}" % tuple(map(as_float, one[2:])) for one in limits)
    return f"""/* Written by describe.py: what {robot["name"]} says of itself. */
#include "ganglion_robot.h"

enum {{ kSensations = {values}, kCommands = {len(limits)}, kTickMs = {round(robot.get("tick_s", 0.1) * 1000)}, \
kFreeRunning = {int(free_running)} }};
static const ganglion_robot_limits kLimits[] = {{
  {rows}}};
#ifdef GANGLION_ROBOT_STREAM
{table_of(len(frame).to_bytes(4, "big") + frame)}
#else
{table_of(packet(frame))}
#endif
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("robot")
    parser.add_argument("--lock-step", action="store_true", help="its time can stand still: a simulation")
    parser.add_argument("--no-free-running", action="store_true")
    arguments = parser.parse_args()
    robot = read_toml(arguments.robot)
    frame = describe(robot, arguments.lock_step, not arguments.no_free_running)
    sys.stdout.write(header(robot, frame, not arguments.no_free_running))


if __name__ == "__main__":
    main()
