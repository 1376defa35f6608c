// What happens in a box that is turned? Shows a digest every eight frames: those of Rust and of demo/tilt_box.c.
//
// An accelerometer would give the readings; here they are scripted, so that every board shows the same.
#include <carom.h>

// The world lives here: sixteen grains at most, and four walls.
static CAROM_MEMORY(memory, CAROM_2D_F32_BYTES(16, 4));
static carom_world_2d_f32 *world;
static int frame = 0;

// Gravity turns once in eight readings.
static const float readings[8][2] = {
    {0.0f, -9.81f}, {6.94f, -6.94f}, {9.81f, 0.0f},  {6.94f, 6.94f},
    {0.0f, 9.81f},  {-6.94f, 6.94f}, {-9.81f, 0.0f}, {-6.94f, -6.94f},
};

// One of sixteen on a lattice. All numbers but the mass are exact.
static carom_grain_2d_f32 grain(int k) {
  carom_grain_2d_f32 grain;
  grain.radius = (8 + k % 4) / 2048.0f;
  grain.mass = grain.radius * grain.radius * grain.radius * 10000.0f;
  grain.position[0] = (2 * (k % 4) + 1) / 128.0f;
  grain.position[1] = (2 * (k / 4) + 1) / 128.0f;
  grain.velocity[0] = (k * 5 % 16 - 7.5f) / 16.0f;
  grain.velocity[1] = (k * 3 % 16 - 7.5f) / 16.0f;
  return grain;
}

// Shows why a call was refused, and stops. The number's name takes 1 KB of flash, an error's text would take 20.
static void check(carom_error error) {
  if (error == CAROM_OK) return;
  Serial.println(carom_error_name(error));
  for (;;) delay(1000);
}

void setup() {
  const float low[2] = {0.0f, 0.0f}, high[2] = {0.0625f, 0.0625f};
  Serial.begin(115200);
  check(carom_2d_f32_create(memory, sizeof memory, 16, 4, &world));
  check(carom_2d_f32_set_viscoelastic(world, 1.0e6f, 0.4f, 2.0e-4f, CAROM_TABLE_COMPACT));
  check(carom_2d_f32_add_walls(world, low, high));
  check(carom_2d_f32_set_gravity(world, readings[0]));
  for (int k = 0; k < 16; k++) {
    carom_grain_2d_f32 next = grain(k);
    check(carom_2d_f32_add_grain(world, &next));
  }
  check(carom_2d_f32_start(world));
}

// Sixteen hexadecimal digits.
static void show(uint64_t digest) {
  for (int shift = 60; shift >= 0; shift -= 4) {
    const char digit[2] = {"0123456789abcdef"[(digest >> shift) & 15], 0};
    Serial.print(digit);
  }
  Serial.println("");
}

void loop() {
  frame++;
  check(carom_2d_f32_set_gravity(world, readings[frame / 5 % 8]));
  check(carom_2d_f32_advance_to(world, frame / 40.0));
  if (frame % 8 == 0) {
    uint64_t digest;
    check(carom_2d_f32_digest(world, &digest));
    Serial.print(frame);
    Serial.print(" ");
    show(digest);
  }
  if (frame == 40) {
    for (;;) delay(1000);
  }
}
