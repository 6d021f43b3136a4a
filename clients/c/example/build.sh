#!/bin/sh
# build.sh [FOLDER]: makes FOLDER/nimrod.elf (default: build). Needs gcc-arm-none-eabi and python3.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
into=${1:-build}
mkdir -p "$into"
python3 "$here/../describe.py" "$here/robot.toml" --lock-step >"$into/describe.h"
arm-none-eabi-gcc -std=c99 -Os -mcpu=cortex-m0 -mthumb -ffreestanding -ffunction-sections -Wl,--gc-sections \
  -Wall -Wextra -Wpedantic -I"$into" -I"$here/.." "$here"/*.c "$here/../ganglion_robot.c" \
  -nostdlib -T "$here/microbit.ld" -lgcc -o "$into/nimrod.elf"
