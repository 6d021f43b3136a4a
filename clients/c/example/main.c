/* A whole robot: Nimrod's body in a corridor, on the link over the serial line of a micro:bit. A real one reads its
 * sonars in sense() and sets its motors in act(); step() and reset() it leaves out, for its time goes by itself. */
#include "corridor.h"
#include "describe.h"
#include "microbit.h"

static corridor world;
static uint32_t commanded_ms; /* when it was last told to move */
static uint32_t stopped_after_ms;
static bool moves, lock_step;

static void write(void* user, const uint8_t* bytes, size_t count) {
  (void)user;
  microbit_write(bytes, count);
}

static void sense(void* user, float* values) {
  (void)user;
  values[0] = corridor_range_m(&world, 0.12F, 0.10F, 0.087F);
  values[1] = corridor_range_m(&world, 0.12F, -0.10F, -0.087F);
  values[2] = world.yaw_rad;
  values[3] = world.x_m;
  values[4] = world.y_m;
  values[5] = (float)world.contacts;
  values[6] = (float)stopped_after_ms / 1000;
}

static void act(void* user, const float* values) {
  (void)user;
  const uint32_t now_ms = microbit_ms();
  world.left = values[0];
  world.right = values[1];
  if (world.left != 0 || world.right != 0) {
    moves = true;
    commanded_ms = now_ms;
  } else if (moves) {
    moves = false;
    stopped_after_ms = now_ms - commanded_ms;
  }
}

static void step(void* user, uint32_t step_ms) {
  (void)user;
  lock_step = true; /* from now on the world's time is the controller's */
  corridor_step(&world, step_ms);
}

static void reset(void* user) {
  (void)user;
  lock_step = false;
  corridor_reset(&world);
}

static uint32_t random_number(void* user) {
  (void)user;
  return microbit_random();
}

static GANGLION_ROBOT_OUT(kSensations) out;
static uint8_t frame[GANGLION_ROBOT_FRAME_BYTES(kCommands)];
static const ganglion_robot_config kConfig = {
    .describe = kDescribe,
    .describe_bytes = sizeof kDescribe,
    .sensations = kSensations,
    .commands = kCommands,
    .limits = kLimits,
    .tick_ms = kTickMs,
    .free_running = kFreeRunning,
    .values = out.values,
    .frame = frame,
    .frame_bytes = sizeof frame,
    .write = write,
    .sense = sense,
    .act = act,
    .random = random_number,
    .step = step,
    .reset = reset,
};

int main(void) {
  static ganglion_robot robot;
  microbit_init();
  corridor_reset(&world);
  ganglion_robot_init(&robot, &kConfig);
  uint32_t moved_ms = microbit_ms();
  for (;;) {
    const uint32_t now_ms = microbit_ms();
    uint8_t byte;
    for (int n = 0; n < GANGLION_ROBOT_TURN && microbit_read(&byte); ++n) {
      ganglion_robot_receive(&robot, byte, now_ms);
    }
    ganglion_robot_poll(&robot, now_ms);
    if (now_ms - moved_ms >= 10) {
      if (!lock_step) corridor_step(&world, now_ms - moved_ms);
      moved_ms = now_ms;
    }
    microbit_sleep();
  }
}
