/* The robot's end of the Ganglion link (docs/link.md, protocol 1.0) for microcontrollers: C99, no heap, no libc, about
 * 2 KB of flash on a Cortex-M0+. Binary frames, over a serial line (packets with a checksum); over a TCP connection
 * with GANGLION_ROBOT_STREAM defined. What it does by itself: Hello with session token and resuming, Describe, Sense at
 * every tick, Act (limits, order of ticks, time to live), Beat, Reset, Bye. One line, one controller, no watchers.
 *
 * Left out: JSON, Step (refused), ages of readings (all count as fresh) and energy; where commands have times to live
 * of their own, the shortest one holds for all of them.
 *
 * Nothing that arrives makes it read or write outside the buffers it was given. */
#ifndef GANGLION_ROBOT_H
#define GANGLION_ROBOT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Room for the frames a controller sends to a robot with so many command values. */
#define GANGLION_ROBOT_FRAME_BYTES(commands) (160 + 20 * (commands))
/* A variable for what is sent, where sensations or commands, whichever are more, have so many values. */
#define GANGLION_ROBOT_OUT(most_values) \
  struct {                              \
    uint8_t head[32];                   \
    float values[most_values];          \
    uint8_t tail[4];                    \
  }

/* Limits of one command value, in its own unit; all finite. */
typedef struct {
  float min, max;
  float safe; /* taken when nobody commands */
} ganglion_robot_limits;

/* What the robot is. Constant, so that it stays in flash. describe.py writes the numbers from a robot.toml. */
typedef struct {
  const uint8_t* describe; /* with all that goes round it on the line */
  uint16_t describe_bytes;
  uint16_t sensations; /* values in a Sense */
  uint16_t commands;   /* values in an Act */
  const ganglion_robot_limits* limits;
  uint16_t tick_ms;  /* between two Senses when free-running; at least 1 */
  bool free_running; /* as Describe says; lock-step it can where `step` is given */

  float* values;  /* those of a GANGLION_ROBOT_OUT(): what lies round them is used as well */
  uint8_t* frame; /* for what arrives: GANGLION_ROBOT_FRAME_BYTES() */
  uint16_t frame_bytes;

  void (*write)(void* user, const uint8_t* bytes, size_t count); /* to the line; waits for room if need be */
  void (*sense)(void* user, float* values);                      /* measures: all sensations in the order of Describe */
  void (*act)(void* user, const float* values);                  /* drives: finite, within the limits */
  uint32_t (*random)(void* user); /* for session tokens: another number after every start */
  /* What may be left out comes last: older C++ compilers, those of Arduino, want initialisers without gaps. */
  void* user;                                 /* handed to all of these */
  void (*step)(void* user, uint32_t step_ms); /* lock-step: lets that time pass; null where time goes by itself */
  void (*reset)(void* user);                  /* begins again, at tick 0; null where that cannot be */
} ganglion_robot_config;

/* The state. Only the functions below touch it. */
typedef struct {
  bool session, accepted, free_running; /* there is a token; its connection stands; its pace */
  bool holds;                           /* commands are being carried out, until_ms */
#ifdef GANGLION_ROBOT_STREAM
  bool closing; /* all is said */
#else
  bool zero_due; /* in the packet that is arriving */
#endif
  uint8_t left;             /* of the piece that is arriving */
  char token[9];            /* ends with a zero */
  uint16_t bytes, crc;      /* of the frame that is arriving */
  uint32_t tick, next_tick; /* commands for ticks before next_tick are old (free-running) */
  uint32_t time_ms, ticked_ms, until_ms;
  const ganglion_robot_config* config;
#ifdef GANGLION_ROBOT_STREAM
  uint32_t announced; /* length of the frame that is arriving */
#endif
} ganglion_robot;

/* Begins, with safe values. `config` must outlive the robot. */
void ganglion_robot_init(ganglion_robot* robot, const ganglion_robot_config* config);

/* A TCP connection stands; not needed on serial lines. */
void ganglion_robot_connected(ganglion_robot* robot);

/* A byte has arrived. False: close the connection (TCP only). now_ms is any clock that goes on, and may wrap. However
 * many bytes wait: no more than GANGLION_ROBOT_TURN of them before the next ganglion_robot_poll(). */
enum { GANGLION_ROBOT_TURN = 64 };
bool ganglion_robot_receive(ganglion_robot* robot, uint8_t byte, uint32_t now_ms);

/* Time passes: takes safe values in time, sends Sense. To be called at least every few milliseconds. */
void ganglion_robot_poll(ganglion_robot* robot, uint32_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
