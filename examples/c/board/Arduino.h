// What does a sketch need of an Arduino core? As much of one as TiltBox uses, for QEMU's mps2-an386; see board.cpp.
#pragma once
#include <stddef.h>
#include <stdint.h>

struct Console {
  void begin(unsigned long) {}
  void print(const char *text);
  void print(int number);
  void println(const char *text);
};
extern Console Serial;

// Waits; here the program ends, as nothing comes after it.
void delay(unsigned long milliseconds);

void setup();
void loop();
