// What is between QEMU's mps2-an386 (Cortex-M4F) and a sketch? Start-up, and a console and an end by semihosting.
#include "Arduino.h"

extern "C" {
extern uint32_t stack_top, data_from, data_start, data_end, bss_start, bss_end;
void reset(void);
void fault(void);

// Where the stack begins, and what happens at reset and at each fault.
__attribute__((section(".vectors"), used)) void (*const vectors[16])(void) = {
    reinterpret_cast<void (*)(void)>(&stack_top), reset, fault, fault, fault, fault, fault};
}

// One call of Arm's semihosting.
static void host(int call, const void *argument) {
  register int r0 asm("r0") = call;
  register const void *r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

// SYS_EXIT_EXTENDED with ADP_Stopped_ApplicationExit and this code.
[[noreturn]] static void leave(uint32_t code) {
  const uint32_t reason[2] = {0x20026, code};
  for (;;) host(0x20, reason);
}

Console Serial;

void Console::print(const char *text) { host(0x04, text); }

void Console::print(int number) {
  char digits[12];
  char *next = digits + sizeof digits;
  *--next = 0;
  do *--next = static_cast<char>('0' + number % 10);
  while ((number /= 10) != 0);
  print(next);
}

void Console::println(const char *text) {
  print(text);
  print("\n");
}

void delay(unsigned long) { leave(0); }

void fault() { leave(2); }

void reset() {
  *reinterpret_cast<volatile uint32_t *>(0xE000ED88) |= 0xFu << 20;  // CPACR: the floating-point unit is on
  asm volatile("dsb\n isb" ::: "memory");
  const uint32_t *from = &data_from;
  for (uint32_t *to = &data_start; to < &data_end;) *to++ = *from++;
  for (uint32_t *to = &bss_start; to < &bss_end;) *to++ = 0;
  setup();
  for (;;) loop();
}
