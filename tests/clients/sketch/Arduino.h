#pragma once

// As much of an Arduino as clients/c/arduino needs, in memory.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

enum : std::uint8_t { A0 = 14, A1 = 15, A5 = 19, OUTPUT = 1, LOW = 0, HIGH = 1 };

struct Board {
  std::uint32_t ms = 0;
  int analog[20] = {};  // what a pin reads, or the duty that was written to it
  int digital[20] = {};
  std::string received, sent;
};
inline Board board;

struct Line {
  void begin(long) {}
  int available() const { return static_cast<int>(board.received.size()); }
  int read() {
    const auto byte = static_cast<unsigned char>(board.received.front());
    board.received.erase(0, 1);
    return byte;
  }
  void write(const std::uint8_t* bytes, std::size_t count) {
    board.sent.append(reinterpret_cast<const char*>(bytes), count);
  }
};
inline Line Serial;

inline std::uint32_t millis() { return board.ms; }
inline std::uint32_t micros() { return board.ms * 1000; }
inline int analogRead(int pin) { return board.analog[pin]; }
inline void analogWrite(int pin, int duty) { board.analog[pin] = duty; }
inline void digitalWrite(int pin, int level) { board.digital[pin] = level; }
inline void pinMode(int, int) {}
