#include "ganglion_robot.h"

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "floats go out as they lie in memory: low byte first"
#endif

enum { HELLO = 1, SENSE = 3, ACT = 4, STEP = 5, RESET = 7, BYE = 8, BEAT = 9 }; /* messages */
enum { VERSION = 1, BROKEN = 3, NO_SESSION = 6, REFUSED = 8, TOO_MANY = 9 };    /* codes of Bye */
enum { VARINT = 0, FIXED64 = 1, BYTES = 2, FIXED32 = 5 };                       /* wire types */
enum { DEFAULT_TTL_MS = 300, MAX_TTL_MS = 500, MAX_STEP_MS = 3600000, TOKEN_BYTES = 8 };

/* -- Reading protobuf ------------------------------------------------------------------------------------------- */

enum { FIELDS = 11 }; /* no message has one of a higher number that matters here */

/* The fields of a message by their numbers; those that did not come are 0. */
typedef struct {
  uint32_t value[FIELDS]; /* of varints: their lower 32 bits */
  uint32_t size[FIELDS];  /* of all others: bytes there are `at` */
  const uint8_t* at[FIELDS];
} fields;

static bool read_varint(const uint8_t** at, const uint8_t* end, uint32_t* value) {
  unsigned shift = 0;
  *value = 0;
  while (*at != end && shift < 70) {
    const uint8_t byte = *(*at)++;
    if (shift < 32) *value |= (uint32_t)(byte & 0x7F) << shift;
    if (byte < 0x80) return true;
    shift += 7;
  }
  return false;
}

/* False where the bytes follow no rule, or something comes twice: then it is not for one robot. */
static bool read_fields(const uint8_t* at, uint32_t bytes, fields* out) {
  const uint8_t* const end = at + bytes;
  uint32_t seen = 0;
  for (unsigned n = 0; n < FIELDS; ++n) {
    out->value[n] = out->size[n] = 0;
    out->at[n] = at;
  }
  while (at != end) {
    uint32_t tag, value = 0, size = 0;
    if (!read_varint(&at, end, &tag)) return false;
    const uint8_t type = tag & 7;
    tag >>= 3;
    if (type == FIXED64) {
      size = 8;
    } else if (type == FIXED32) {
      size = 4;
    } else if (type > BYTES || !read_varint(&at, end, type == VARINT ? &value : &size)) {
      return false;
    }
    if (size > (uint32_t)(end - at)) return false;
    if (tag < FIELDS) {
      if (seen >> tag & 1) return false;
      seen |= (uint32_t)1 << tag;
      out->value[tag] = value;
      out->size[tag] = size;
      out->at[tag] = at;
    }
    at += size;
  }
  return true;
}

/* Low byte first. */
static uint32_t word_at(const uint8_t* at) {
  uint32_t word = 0;
  for (unsigned n = 4; n-- > 0;) word = word << 8 | at[n];
  return word;
}

/* Seconds as a double, good to 21 bits, in whole ms: 0 for 0 only, more than MAX_STEP_MS for what is too long, negative
 * or no number. */
static uint32_t ms_at(const uint8_t* at) {
  uint32_t upper = word_at(at + 4);
  const uint32_t shift = 1023 + 20 - (upper >> 20); /* sign and exponent */
  if (shift < 9 || shift > 1023 + 20) return MAX_STEP_MS + 1;
  if (shift > 30) return upper != 0;
  upper = (upper & 0xFFFFF) | 0x100000;
  return ((upper * 1000 >> (shift - 1)) + 1) >> 1;
}

/* -- Sending ---------------------------------------------------------------------------------------------------- */

/* A frame is written from its end to its front, so that each length is known when its turn comes: `at` is its first
 * byte so far. Its end is where the values are, or behind them. */
typedef struct {
  uint8_t *at, *end;
} frame;

static void begin(const ganglion_robot* robot, frame* out, unsigned value_count) {
  out->at = (uint8_t*)robot->config->values;
  out->end = out->at + value_count * sizeof(float);
}

static void prepend(frame* out, uint32_t value) {
  const uint32_t rest = value >> 7;
  if (rest) prepend(out, rest);
  *--out->at = (uint8_t)((value & 0x7F) | (rest ? 0x80 : 0));
}

static void prepend_number(frame* out, unsigned number, uint32_t value) {
  prepend(out, value);
  prepend(out, number << 3 | VARINT);
}

/* All that was written so far becomes one field. */
static void wrap(frame* out, unsigned number) {
  prepend(out, (uint32_t)(out->end - out->at));
  prepend(out, number << 3 | BYTES);
}

/* Begins a frame with a text of at most 20 bytes. */
static void begin_text(const ganglion_robot* robot, frame* out, unsigned number, const char* text) {
  unsigned bytes = 0;
  while (text[bytes]) ++bytes;
  begin(robot, out, 0);
  while (bytes > 0) *--out->at = (uint8_t)text[--bytes];
  wrap(out, number);
}

static void write(const ganglion_robot* robot, const uint8_t* at, uint32_t bytes) {
  robot->config->write(robot->config->user, at, bytes);
}

#ifdef GANGLION_ROBOT_STREAM

static void send(const ganglion_robot* robot, frame* out) {
  const uint32_t bytes = (uint32_t)(out->end - out->at);
  const uint8_t length[4] = {(uint8_t)(bytes >> 24), (uint8_t)(bytes >> 16), (uint8_t)(bytes >> 8), (uint8_t)bytes};
  write(robot, length, 4);
  write(robot, out->at, bytes);
}

#else

static uint16_t crc16(uint16_t crc, uint8_t byte) {
  uint32_t bits = (uint32_t)crc << 8 ^ (uint32_t)byte << 16;
  for (int bit = 0; bit < 8; ++bit) {
    bits <<= 1;
    if (bits & 0x1000000) bits ^= 0x102100;
  }
  return (uint16_t)(bits >> 8);
}

/* Ends a packet, and goes ahead of it, so that what was printed on the line before does not spoil it. */
static const uint8_t kZero = 0;

/* There are two bytes of room behind the end. */
static void send(const ganglion_robot* robot, frame* out) {
  uint16_t crc = 0xFFFF;
  for (const uint8_t* at = out->at; at != out->end; ++at) crc = crc16(crc, *at);
  *out->end++ = (uint8_t)(crc >> 8);
  *out->end++ = (uint8_t)crc;
  write(robot, &kZero, 1);
  for (const uint8_t* at = out->at;; ++at) {
    const uint8_t* const piece = at;
    while (at != out->end && *at != 0 && at - piece < 254) ++at;
    uint8_t size = (uint8_t)(at - piece + 1);
    write(robot, &size, 1);
    write(robot, piece, size - 1U);
    if (at == out->end) break;
    if (size == 255) --at; /* no zero follows such a piece */
  }
  write(robot, &kZero, 1);
}

#endif

static void send_sense(const ganglion_robot* robot) {
  const ganglion_robot_config* config = robot->config;
  frame out;
  config->sense(config->user, config->values);
  begin(robot, &out, config->sensations);
  wrap(&out, 6); /* values32 */
  prepend_number(&out, 9, robot->time_ms);
  prepend_number(&out, 1, robot->tick);
  wrap(&out, SENSE);
  send(robot, &out);
}

/* -- The session ------------------------------------------------------------------------------------------------ */

static void take_safe_values(ganglion_robot* robot) {
  const ganglion_robot_config* config = robot->config;
  for (unsigned n = 0; n < config->commands; ++n) config->values[n] = config->limits[n].safe;
  robot->holds = false;
  config->act(config->user, config->values);
}

static void close(ganglion_robot* robot) {
#ifdef GANGLION_ROBOT_STREAM
  robot->closing = true;
#else
  (void)robot; /* nobody can close a serial line */
#endif
}

static void end_session(ganglion_robot* robot) {
  robot->session = robot->accepted = false;
  close(robot);
  take_safe_values(robot);
}

static void refuse(ganglion_robot* robot, unsigned code, const char* reason) {
  frame out;
  begin_text(robot, &out, 1, reason);
  prepend_number(&out, 2, code);
  wrap(&out, BYE);
  send(robot, &out);
  robot->accepted = false;
  close(robot);
  if (code == BROKEN) end_session(robot);
}

static void begin_session(ganglion_robot* robot) {
  uint32_t random = robot->config->random(robot->config->user);
  for (unsigned n = 0; n < TOKEN_BYTES; ++n, random >>= 4) robot->token[n] = (char)('a' + (random & 15));
  robot->session = true;
  robot->next_tick = 0;
  take_safe_values(robot);
}

static void send_greeting(ganglion_robot* robot, bool resumed) {
  frame out;
  begin_text(robot, &out, 3, robot->token);
  prepend_number(&out, 10, resumed);
  prepend_number(&out, 8, 1); /* floats */
  prepend_number(&out, 4, robot->tick);
  prepend_number(&out, 1, 1); /* major */
  wrap(&out, HELLO);
  send(robot, &out);
  write(robot, robot->config->describe, robot->config->describe_bytes);
  send_sense(robot);
}

static bool same_session(const ganglion_robot* robot, const fields* hello) {
  if (!robot->session || hello->size[3] != TOKEN_BYTES) return false;
  for (unsigned n = 0; n < TOKEN_BYTES; ++n) {
    if (hello->at[3][n] != robot->token[n]) return false;
  }
  return true;
}

static void greet(ganglion_robot* robot, const fields* hello, uint32_t now_ms) {
  const ganglion_robot_config* config = robot->config;
  const bool free_running = hello->value[7] != 0;
  const bool resumed = hello->size[3] > 0;
  if (hello->value[1] != 1) {
    refuse(robot, VERSION, "not protocol 1");
  } else if (hello->value[6] != 0) {
    refuse(robot, TOO_MANY, "no watchers");
  } else if (free_running ? !config->free_running : !config->step) {
    refuse(robot, REFUSED, "other pace");
  } else if (resumed && !same_session(robot, hello)) {
    refuse(robot, NO_SESSION, "unknown token");
  } else {
    if (!resumed) begin_session(robot);
    robot->accepted = true;
    robot->free_running = free_running;
    if (free_running) robot->time_ms = now_ms;
    robot->ticked_ms = now_ms;
    send_greeting(robot, resumed);
  }
}

/* -- Commands --------------------------------------------------------------------------------------------------- */

/* `packed` holds a float for each value. */
static void drive(ganglion_robot* robot, const uint8_t* packed) {
  const ganglion_robot_config* config = robot->config;
  const ganglion_robot_limits* limits = config->limits;
  float* const values = config->values;
  for (unsigned n = 0; n < config->commands; ++n, ++limits, packed += 4) {
    const union {
      uint32_t bits;
      float value;
    } number = {.bits = word_at(packed)};
    float value = number.value;
    if (number.bits << 1 >= 0xFF000000) value = limits->safe; /* infinite, or no number */
    if (value < limits->min) value = limits->min;
    if (value > limits->max) value = limits->max;
    values[n] = value;
  }
  robot->holds = true;
  config->act(config->user, values);
}

static void act_in_lock_step(ganglion_robot* robot, const uint8_t* packed, uint32_t ttl_ms, uint32_t step_ms) {
  const ganglion_robot_config* config = robot->config;
  const uint32_t held_ms = ttl_ms < step_ms ? ttl_ms : step_ms;
  drive(robot, packed);
  config->step(config->user, held_ms);
  if (held_ms < step_ms) {
    take_safe_values(robot);
    config->step(config->user, step_ms - held_ms);
  }
  robot->time_ms += step_ms;
  ++robot->tick;
  send_sense(robot);
}

static void act(ganglion_robot* robot, const fields* in, uint32_t now_ms) {
  const ganglion_robot_config* config = robot->config;
  const uint32_t tick = in->value[1];
  uint32_t ttl_ms = in->value[2] ? in->value[2] : DEFAULT_TTL_MS;
  uint32_t step_ms = in->size[3] == 8 ? ms_at(in->at[3]) : 0;
  if (step_ms == 0) step_ms = config->tick_ms;
  if (step_ms > MAX_STEP_MS || in->size[5] != config->commands * sizeof(float)) {
    refuse(robot, BROKEN, "malformed");
    return;
  }
  for (uint32_t n = 8; n <= in->size[6]; n += 8) {
    const uint32_t own_ms = ms_at(in->at[6] + n - 8);
    if (own_ms < ttl_ms) ttl_ms = own_ms;
  }
  if (robot->free_running) {
    if (tick < robot->next_tick) return;
    robot->next_tick = tick + 1;
    robot->until_ms = now_ms + (ttl_ms < MAX_TTL_MS ? ttl_ms : MAX_TTL_MS);
    drive(robot, in->at[5]);
  } else if (tick < robot->tick) {
    send_sense(robot); /* carried out before; the answer got lost */
  } else if (tick > robot->tick) {
    refuse(robot, BROKEN, "future tick");
  } else {
    act_in_lock_step(robot, in->at[5], ttl_ms, step_ms);
  }
}

static void answer_beat(const ganglion_robot* robot, const fields* beat, uint32_t now_ms) {
  frame out;
  if (beat->value[2]) return; /* an answer itself */
  begin(robot, &out, 0);
  prepend_number(&out, 4, now_ms);
  prepend_number(&out, 2, 1);
  prepend_number(&out, 1, beat->value[1]);
  wrap(&out, BEAT);
  send(robot, &out);
}

/* `echo` is the frame that asked for it. */
static void reset(ganglion_robot* robot, frame* echo) {
  take_safe_values(robot);
  robot->next_tick = 0;
  if (robot->config->reset) {
    robot->tick = robot->time_ms = 0; /* free-running, the time comes with the next tick */
    robot->config->reset(robot->config->user);
  }
  send(robot, echo);
  send_sense(robot);
}

static void handle(ganglion_robot* robot, uint16_t bytes, uint32_t now_ms) {
  frame whole = {robot->config->frame, robot->config->frame + bytes};
  const uint8_t* at = whole.at + 1;
  const unsigned kind = *whole.at >> 3;
  uint32_t size;
  fields in;
  if (kind > BEAT || (*whole.at & 7) != BYTES) return; /* of a later version, or JSON */
  if (!read_varint(&at, whole.end, &size) || size > (uint32_t)(whole.end - at) || !read_fields(at, size, &in)) {
    refuse(robot, BROKEN, "malformed");
  } else if (kind == HELLO) {
    greet(robot, &in, now_ms);
  } else if (robot->accepted) { /* else it is left over from an earlier connection */
    if (kind == ACT) act(robot, &in, now_ms);
    if (kind == STEP) refuse(robot, REFUSED, "no Step");
    if (kind == RESET) reset(robot, &whole);
    if (kind == BEAT) answer_beat(robot, &in, now_ms);
    if (kind == BYE) end_session(robot);
  }
}

/* -- Bytes in --------------------------------------------------------------------------------------------------- */

#ifdef GANGLION_ROBOT_STREAM

static void await_frame(ganglion_robot* robot) { robot->bytes = robot->left = 0; }

/* `left` counts the bytes of the length that have come. */
static void take(ganglion_robot* robot, uint8_t byte, uint32_t now_ms) {
  if (robot->left < 4) {
    robot->announced = robot->announced << 8 | byte;
    if (++robot->left < 4) return;
    if (robot->announced > robot->config->frame_bytes) refuse(robot, BROKEN, "frame too long");
  } else {
    robot->config->frame[robot->bytes++] = byte;
  }
  if (robot->bytes < robot->announced) return;
  if (robot->bytes > 0) handle(robot, robot->bytes, now_ms);
  await_frame(robot);
}

#else

static void await_frame(ganglion_robot* robot) {
  robot->bytes = robot->left = 0;
  robot->crc = 0xFFFF;
  robot->zero_due = false;
}

/* What is too long gets a CRC that cannot be right. */
static void put(ganglion_robot* robot, uint8_t byte) {
  if (robot->bytes == robot->config->frame_bytes) return;
  robot->crc = crc16(robot->crc, byte);
  robot->config->frame[robot->bytes++] = byte;
}

static void take(ganglion_robot* robot, uint8_t byte, uint32_t now_ms) {
  if (byte == 0) {
    const bool whole = robot->left == 0 && robot->crc == 0; /* that of bytes and their CRC is 0 */
    if (whole && robot->bytes > 2) handle(robot, (uint16_t)(robot->bytes - 2), now_ms);
    await_frame(robot);
  } else if (robot->left > 0) {
    --robot->left;
    put(robot, byte);
  } else {
    if (robot->zero_due) put(robot, 0);
    robot->left = (uint8_t)(byte - 1);
    robot->zero_due = byte != 0xFF;
  }
}

#endif

bool ganglion_robot_receive(ganglion_robot* robot, uint8_t byte, uint32_t now_ms) {
#ifdef GANGLION_ROBOT_STREAM
  if (!robot->closing) take(robot, byte, now_ms);
  return !robot->closing;
#else
  take(robot, byte, now_ms);
  return true;
#endif
}

/* -- The rest --------------------------------------------------------------------------------------------------- */

void ganglion_robot_init(ganglion_robot* robot, const ganglion_robot_config* config) {
  *robot = (ganglion_robot){.config = config};
  ganglion_robot_connected(robot);
  take_safe_values(robot);
}

void ganglion_robot_connected(ganglion_robot* robot) {
  robot->accepted = false;
#ifdef GANGLION_ROBOT_STREAM
  robot->closing = false;
#endif
  await_frame(robot);
}

void ganglion_robot_poll(ganglion_robot* robot, uint32_t now_ms) {
  if (!robot->session || !robot->free_running) return;
  if (robot->holds && (int32_t)(now_ms - robot->until_ms) >= 0) take_safe_values(robot);
  if (now_ms - robot->ticked_ms < robot->config->tick_ms) return;
  robot->ticked_ms = robot->time_ms = now_ms;
  ++robot->tick;
  if (robot->accepted) send_sense(robot);
}
