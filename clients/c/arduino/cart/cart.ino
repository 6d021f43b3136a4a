// A sketch to begin from: two motors behind an H-bridge and two infrared range finders, on the link over USB.
// Put ganglion_robot.h, ganglion_robot.c and describe.h beside it:
//   python3 describe.py arduino/cart/robot.toml > arduino/cart/describe.h
// Then: ganglion doctor --robot "serial:///dev/ttyACM0?baud=115200"
#include "describe.h"

const uint8_t kForward[] = {4, 7}, kDuty[] = {5, 6};  // pins of the left and the right motor; kDuty can do PWM
const uint8_t kRange[] = {A0, A1};                    // left and right GP2Y0A21

static void write_line(void*, const uint8_t* bytes, size_t count) { Serial.write(bytes, count); }

static void sense(void*, float* values) {
  for (uint8_t n = 0; n < 2; ++n) {
    const float volt = analogRead(kRange[n]) * 5.0F / 1023;
    const float range_m = volt > 0.1F ? 0.26F / volt : INFINITY;  // about 0.26 V m
    values[n] = range_m > 0.8F ? INFINITY : range_m < 0.1F ? -INFINITY : range_m;
  }
}

static void act(void*, const float* values) {  // duties in [-1, 1]; the safe ones, when nobody commands
  for (uint8_t n = 0; n < 2; ++n) {
    digitalWrite(kForward[n], values[n] >= 0 ? HIGH : LOW);
    analogWrite(kDuty[n], (int)(255 * (values[n] < 0 ? -values[n] : values[n])));
  }
}

static uint32_t random_number(void*) {  // the lowest bit of a pin that is not connected, and the time of a Hello
  uint32_t value = micros();
  for (uint8_t n = 0; n < 32; ++n) value = (value << 1 | value >> 31) ^ (uint32_t)(analogRead(A5) & 1);
  return value;
}

static GANGLION_ROBOT_OUT(kSensations > kCommands ? kSensations : kCommands) out;
static uint8_t frame[GANGLION_ROBOT_FRAME_BYTES(kCommands)];
static const ganglion_robot_config kConfig = {
    .describe = kDescribe,
    .describe_bytes = sizeof kDescribe,
    .sensations = kSensations,
    .commands = kCommands,
    .limits = kLimits,
    .tick_ms = kTickMs,
    .free_running = kFreeRunning != 0,
    .values = out.values,
    .frame = frame,
    .frame_bytes = sizeof frame,
    .write = write_line,
    .sense = sense,
    .act = act,
    .random = random_number,
};
static ganglion_robot robot;

void setup() {
  Serial.begin(115200);
  for (uint8_t n = 0; n < 2; ++n) {
    pinMode(kForward[n], OUTPUT);
    pinMode(kDuty[n], OUTPUT);
  }
  ganglion_robot_init(&robot, &kConfig);
}

void loop() {
  const uint32_t now_ms = millis();
  for (uint8_t n = 0; n < GANGLION_ROBOT_TURN && Serial.available() > 0; ++n) {
    ganglion_robot_receive(&robot, (uint8_t)Serial.read(), now_ms);
  }
  ganglion_robot_poll(&robot, now_ms);
}
