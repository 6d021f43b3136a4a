#include "microbit.h"

/* nRF51 Series Reference Manual 3.0: chapters 18 (TIMER), 21 (RNG), 29 (UART). */
#define REGISTER(address) (*(volatile uint32_t*)(uintptr_t)(address))

#define UART(offset) REGISTER(0x40002000 + (offset))
enum { kUartStartRx = 0x000, kUartStartTx = 0x008, kUartRxReady = 0x108, kUartTxReady = 0x11C };
enum { kUartInterrupts = 0x304, kUartEnable = 0x500, kUartRx = 0x518, kUartTx = 0x51C, kUartBaud = 0x524 };

#define TIMER(offset) REGISTER(0x40008000 + (offset))
enum { kTimerStart = 0x000, kTimerCapture0 = 0x040, kTimerCompared1 = 0x144, kTimerInterrupts = 0x304 };
enum { kTimerBits = 0x508, kTimerPrescaler = 0x510, kTimerCompare0 = 0x540, kTimerCompare1 = 0x544 };

#define RNG(offset) REGISTER(0x4000D000 + (offset))
enum { kRngStart = 0x000, kRngReady = 0x100, kRngValue = 0x508 };

#define NVIC_ENABLE REGISTER(0xE000E100)
#define NVIC_UNPEND REGISTER(0xE000E280)
enum { kUartBit = 1 << 2, kTimerBit = 1 << 8 };

static uint32_t now_us(void) {
  TIMER(kTimerCapture0) = 1;
  return TIMER(kTimerCompare0);
}

void microbit_init(void) {
  __asm volatile("cpsid i");    /* interrupts only end sleep; nothing is done in them */
  UART(kUartBaud) = 0x01D7E000; /* 115,200 */
  UART(kUartEnable) = 4;
  UART(kUartInterrupts) = 1 << 2; /* a byte came */
  UART(kUartStartRx) = 1;
  UART(kUartStartTx) = 1;
  TIMER(kTimerBits) = 3;             /* 32 */
  TIMER(kTimerPrescaler) = 4;        /* 16 MHz / 2^4 */
  TIMER(kTimerInterrupts) = 1 << 17; /* compare 1 */
  TIMER(kTimerStart) = 1;
  RNG(kRngStart) = 1;
  NVIC_ENABLE = kUartBit | kTimerBit;
}

/* The timer's microseconds wrap after 71 minutes, its milliseconds must not. */
uint32_t microbit_ms(void) {
  static uint32_t ms, counted_us;
  const uint32_t more_ms = (now_us() - counted_us) / 1000;
  counted_us += more_ms * 1000;
  return ms += more_ms;
}

bool microbit_read(uint8_t* byte) {
  if (!UART(kUartRxReady)) return false;
  UART(kUartRxReady) = 0;
  *byte = (uint8_t)UART(kUartRx);
  return true;
}

void microbit_write(const uint8_t* bytes, size_t count) {
  for (size_t n = 0; n < count; ++n) {
    UART(kUartTxReady) = 0;
    UART(kUartTx) = bytes[n];
    while (!UART(kUartTxReady)) {
    }
  }
}

uint32_t microbit_random(void) {
  uint32_t value = 0;
  for (int n = 0; n < 4; ++n) {
    while (!RNG(kRngReady)) {
    }
    RNG(kRngReady) = 0;
    value = value << 8 | RNG(kRngValue);
  }
  return value;
}

void microbit_sleep(void) {
  TIMER(kTimerCompared1) = 0;
  NVIC_UNPEND = kUartBit | kTimerBit;
  TIMER(kTimerCompare1) = now_us() + 1000;
  if (!UART(kUartRxReady)) __asm volatile("wfi");
}
