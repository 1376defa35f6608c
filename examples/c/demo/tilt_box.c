// What happens in a box that is turned? Shows a digest every eight frames: those of Rust and of the Arduino sketch.
//
//     cargo build --release && cc -Iinclude demo/tilt_box.c target/release/libcarom_c.a -lm -o tilt_box && ./tilt_box
#include "carom.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

// The world lives here: sixteen grains at most, and four walls.
static CAROM_MEMORY(memory, CAROM_2D_F32_BYTES(16, 4));

// Gravity turns once in eight readings.
static const float readings[8][2] = {
    {0.0f, -9.81f}, {6.94f, -6.94f}, {9.81f, 0.0f},  {6.94f, 6.94f},
    {0.0f, 9.81f},  {-6.94f, 6.94f}, {-9.81f, 0.0f}, {-6.94f, -6.94f},
};

// One of sixteen on a lattice. All numbers but the mass are exact.
static carom_grain_2d_f32 grain(int k) {
  carom_grain_2d_f32 grain;
  grain.radius = (float)(8 + k % 4) / 2048.0f;
  grain.mass = grain.radius * grain.radius * grain.radius * 10000.0f;
  grain.position[0] = (float)(2 * (k % 4) + 1) / 128.0f;
  grain.position[1] = (float)(2 * (k / 4) + 1) / 128.0f;
  grain.velocity[0] = ((float)(k * 5 % 16) - 7.5f) / 16.0f;
  grain.velocity[1] = ((float)(k * 3 % 16) - 7.5f) / 16.0f;
  return grain;
}

// Ends the program if a call was refused, with its reason.
static void check(carom_world_2d_f32 *world, carom_error error, const char *what) {
  char text[200] = "";
  if (error == CAROM_OK) return;
  carom_2d_f32_error_text(world, text, sizeof text);
  fprintf(stderr, "%s: %s: %s %s\n", what, carom_error_name(error), carom_error_meaning(error), text);
  exit(1);
}

static carom_world_2d_f32 *build(void) {
  carom_world_2d_f32 *world = NULL;
  const float low[2] = {0.0f, 0.0f}, high[2] = {0.0625f, 0.0625f};
  check(world, carom_2d_f32_create(memory, sizeof memory, 16, 4, &world), "create");
  check(world, carom_2d_f32_set_viscoelastic(world, 1.0e6f, 0.4f, 2.0e-4f, CAROM_TABLE_COMPACT), "law");
  check(world, carom_2d_f32_add_walls(world, low, high), "walls");
  check(world, carom_2d_f32_set_gravity(world, readings[0]), "gravity");
  for (int k = 0; k < 16; k++) {
    carom_grain_2d_f32 next = grain(k);
    check(world, carom_2d_f32_add_grain(world, &next), "grain");
  }
  check(world, carom_2d_f32_start(world), "start");
  return world;
}

int main(void) {
  carom_world_2d_f32 *world = build();
  for (int frame = 1; frame <= 40; frame++) {
    uint64_t digest = 0;
    check(world, carom_2d_f32_set_gravity(world, readings[frame / 5 % 8]), "tilt");
    check(world, carom_2d_f32_advance_to(world, frame / 40.0), "advance");
    check(world, carom_2d_f32_digest(world, &digest), "digest");
    if (frame % 8 == 0) printf("%d %016" PRIx64 "\n", frame, digest);
  }
  return 0;
}
