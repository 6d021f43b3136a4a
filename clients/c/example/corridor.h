/* A robot on two tracks between two walls, in single precision: the world of the example. */
#ifndef CORRIDOR_H
#define CORRIDOR_H

typedef struct {
  float x_m, y_m, yaw_rad;
  float left, right; /* duties of the tracks, in [-1, 1] */
  unsigned contacts; /* begun */
} corridor;

/* At the corridor's begin, in the middle, 20 deg off its direction: who only drives on hits a wall. */
void corridor_reset(corridor* world);
/* Lets time pass; in steps of 10 ms. */
void corridor_step(corridor* world, unsigned step_ms);
/* Of a sonar on the body [m]: +infinity beyond 3 m, -infinity nearer than 2 cm. */
float corridor_range_m(const corridor* world, float mount_x_m, float mount_y_m, float mount_yaw_rad);

#endif
