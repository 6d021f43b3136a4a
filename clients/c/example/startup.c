/* From reset to main() without a C library. */
#include <stddef.h>
#include <stdint.h>

extern uint32_t data_begin[], data_end[], data_in_flash[], bss_begin[], bss_end[], stack_top[];
int main(void);

/* The compiler calls these by itself. */
void* memcpy(void* to, const void* from, size_t count) {
  for (size_t n = 0; n < count; ++n) ((volatile uint8_t*)to)[n] = ((const uint8_t*)from)[n];
  return to;
}
void* memset(void* to, int value, size_t count) {
  for (size_t n = 0; n < count; ++n) ((volatile uint8_t*)to)[n] = (uint8_t)value;
  return to;
}

static void reset(void) {
  const uint32_t* from = data_in_flash;
  for (uint32_t* to = data_begin; to < data_end;) *to++ = *from++;
  for (uint32_t* to = bss_begin; to < bss_end;) *to++ = 0;
  main();
}

static void stop(void) {
  for (;;) {
  }
}

/* Stack, reset, NMI and hard fault; no other interrupt is ever taken. */
typedef struct {
  uint32_t* stack;
  void (*handlers[3])(void);
} vectors;
__attribute__((section(".vectors"), used)) static const vectors kVectors = {stack_top, {reset, stop, stop}};
