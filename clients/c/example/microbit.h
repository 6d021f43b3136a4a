/* What the example needs of a BBC micro:bit (nRF51822), as qemu-system-arm -M microbit emulates it. */
#ifndef MICROBIT_H
#define MICROBIT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void microbit_init(void);
uint32_t microbit_ms(void);
/* Whether a byte has come over the serial line. */
bool microbit_read(uint8_t* byte);
void microbit_write(const uint8_t* bytes, size_t count);
uint32_t microbit_random(void);
/* Until a byte comes or a millisecond is over. */
void microbit_sleep(void);

#endif
