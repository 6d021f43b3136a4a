#include "corridor.h"

static const float kPi = 3.14159265F;
static const float kHalfWidth_m = 0.6F, kRadius_m = 0.156F; /* of the corridor; of the robot's disc */
static const float kFullScale_mps = 0.20F, kTrack_m = 0.18F, kRightGain = 0.95F;
static const float kCone_rad = 0.35F, kMinRange_m = 0.02F, kMaxRange_m = 3.0F; /* half the cone */

static float wrapped(float angle_rad) {
  while (angle_rad > kPi) angle_rad -= 2 * kPi;
  while (angle_rad <= -kPi) angle_rad += 2 * kPi;
  return angle_rad;
}

/* Good to 1e-4: the series up to the seventh power, within a quarter turn. */
static float sine(float angle_rad) {
  float a = wrapped(angle_rad);
  if (a > kPi / 2) a = kPi - a;
  if (a < -kPi / 2) a = -kPi - a;
  const float s = a * a;
  return a * (1 - s / 6 * (1 - s / 20 * (1 - s / 42)));
}

static float cosine(float angle_rad) { return sine(angle_rad + kPi / 2); }

void corridor_reset(corridor* world) { *world = (corridor){.yaw_rad = 0.35F}; }

static void move(corridor* world, float step_s) {
  const float left_mps = world->left * kFullScale_mps, right_mps = world->right * kFullScale_mps * kRightGain;
  const float room_m = kHalfWidth_m - kRadius_m, before_m = world->y_m;
  const float way_m = (left_mps + right_mps) / 2 * step_s;
  world->yaw_rad = wrapped(world->yaw_rad + (right_mps - left_mps) / kTrack_m * step_s);
  world->x_m += way_m * cosine(world->yaw_rad);
  world->y_m += way_m * sine(world->yaw_rad);
  const float free_m = world->y_m > room_m ? room_m : world->y_m < -room_m ? -room_m : world->y_m;
  if (free_m != world->y_m && before_m != free_m) ++world->contacts;
  world->y_m = free_m;
}

void corridor_step(corridor* world, unsigned step_ms) {
  for (; step_ms >= 10; step_ms -= 10) move(world, 0.01F);
  if (step_ms > 0) move(world, (float)step_ms / 1000);
}

float corridor_range_m(const corridor* world, float mount_x_m, float mount_y_m, float mount_yaw_rad) {
  const float infinity = __builtin_inff();
  const float y_m = world->y_m + mount_x_m * sine(world->yaw_rad) + mount_y_m * cosine(world->yaw_rad);
  float nearest_m = infinity;
  for (int ray = -2; ray <= 2; ++ray) {
    const float across = sine(world->yaw_rad + mount_yaw_rad + (float)ray / 2 * kCone_rad);
    if (across > -0.01F && across < 0.01F) continue; /* along the walls */
    const float range_m = ((across > 0 ? kHalfWidth_m : -kHalfWidth_m) - y_m) / across;
    if (range_m < nearest_m) nearest_m = range_m;
  }
  return nearest_m > kMaxRange_m ? infinity : nearest_m < kMinRange_m ? -infinity : nearest_m;
}
