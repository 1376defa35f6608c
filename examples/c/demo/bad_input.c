// What does carom say to what C can do wrong? A code each, and nothing written. Ends with 0 if all is as it should be.
#include "carom.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static CAROM_MEMORY(memory, CAROM_3D_F64_BYTES(8, 6));
static CAROM_MEMORY(before, CAROM_3D_F64_BYTES(8, 6));
static CAROM_MEMORY(snapshot, 4096);
static int wrong = 0;

// The memory as it is now.
static void keep(void) { memcpy(before, memory, sizeof memory); }

static void expect(carom_error got, carom_error wanted, const char *what) {
  if (got == wanted) return;
  printf("%s: %s, not %s\n", what, carom_error_name(got), carom_error_name(wanted));
  wrong = 1;
}

static void expect_untouched(const char *what) {
  if (memcmp(before, memory, sizeof memory) == 0) return;
  printf("%s: something was written\n", what);
  wrong = 1;
}

static void creation(void) {
  carom_world_3d_f64 *world = NULL;
  keep();
  expect(carom_3d_f64_create(NULL, sizeof memory, 8, 6, &world), CAROM_ERROR_NULL, "no memory");
  expect(carom_3d_f64_create(memory, sizeof memory, 8, 6, NULL), CAROM_ERROR_NULL, "no place for the pointer");
  expect(carom_3d_f64_create(memory + 4, sizeof memory - 4, 4, 6, &world), CAROM_ERROR_MISALIGNED, "4 bytes off");
  expect(carom_3d_f64_create(memory, 100, 8, 6, &world), CAROM_ERROR_MEMORY, "100 bytes");
  expect(carom_3d_f64_create(memory, carom_3d_f64_bytes(8, 6) - 1, 8, 6, &world), CAROM_ERROR_MEMORY, "one too few");
  expect(carom_3d_f64_create(memory, sizeof memory, UINT32_MAX, 6, &world), CAROM_ERROR_MEMORY, "2^32 grains");
  expect(carom_3d_f64_create(memory, sizeof memory, 1, 9, &world), CAROM_ERROR_MEMORY, "nine planes");
  expect(carom_3d_f64_start((carom_world_3d_f64 *)memory), CAROM_ERROR_NO_WORLD, "zeros");
  expect_untouched("creation");
  if (world != NULL) wrong = 1;
}

static void description(carom_world_3d_f64 *world) {
  const double nan3[3] = {0.0, (double)NAN, 0.0}, zero[3] = {0.0, 0.0, 0.0}, one[3] = {1.0, 1.0, 1.0};
  carom_grain_3d_f64 grain = {{0.5, 0.5, 0.5}, {0.0, 0.0, 0.0}, 0.1, 1.0};
  carom_grain_3d_f64 not_finite = grain, weightless = grain;
  carom_event event;
  uint64_t digest;
  not_finite.velocity[2] = (double)NAN;
  weightless.mass = 0.0;
  keep();
  expect(carom_3d_f64_set_gravity(world, NULL), CAROM_ERROR_NULL, "gravity of nothing");
  expect(carom_3d_f64_add_grain(world, NULL), CAROM_ERROR_NULL, "no grain");
  expect(carom_3d_f64_add_grain(world, (const carom_grain_3d_f64 *)((const char *)&grain + 1)), CAROM_ERROR_MISALIGNED,
         "a grain one byte off");
  expect(carom_2d_f32_set_restitution((carom_world_2d_f32 *)(void *)world, 1.0f), CAROM_ERROR_NO_WORLD,
         "a world of another kind");
  expect(carom_3d_f64_set_linear_dashpot(world, 1.0, 0.0, 7), CAROM_ERROR_TABLE, "table 7");
  expect(carom_3d_f64_set_mode(world, 7), CAROM_ERROR_MODE, "mode 7");
  expect(carom_3d_f64_remove_grain(world, 0, &grain), CAROM_ERROR_NOT_STARTED, "a grain less before the start");
  expect(carom_3d_f64_digest(world, &digest), CAROM_ERROR_NOT_STARTED, "the digest of what has not begun");
  expect(carom_3d_f64_step(world, 1.0, &event), CAROM_ERROR_NOT_STARTED, "a step before the start");
  expect_untouched("description");
  expect(carom_3d_f64_set_gravity(world, nan3), CAROM_ERROR_INPUT, "gravity that is none");
  expect(carom_3d_f64_set_restitution(world, 1.5), CAROM_ERROR_INPUT, "a restitution of 1.5");
  expect(carom_3d_f64_add_grain(world, &not_finite), CAROM_ERROR_INPUT, "a velocity that is none");
  expect(carom_3d_f64_add_grain(world, &weightless), CAROM_ERROR_INPUT, "no mass");
  expect(carom_3d_f64_add_walls(world, one, zero), CAROM_ERROR_INPUT, "a box inside out");
  expect(carom_3d_f64_add_plane(world, one, 0.0), CAROM_ERROR_INPUT, "a normal of length 1.7");
  expect(carom_3d_f64_set_periodic(world, 3, 0.0, 1.0), CAROM_ERROR_INPUT, "axis 3");
  expect(carom_3d_f64_start(world), CAROM_ERROR_INPUT, "no law");
  expect(carom_3d_f64_set_restitution(world, 0.9), CAROM_OK, "a law");
  expect(carom_3d_f64_add_walls(world, zero, one), CAROM_OK, "walls");
  expect(carom_3d_f64_add_plane(world, zero, 0.0), CAROM_ERROR_INPUT, "no normal");
  expect(carom_3d_f64_add_grain(world, &grain), CAROM_OK, "a grain");
  grain.position[0] = 0.99;
  expect(carom_3d_f64_add_grain(world, &grain), CAROM_OK, "one in the wall");
  expect(carom_3d_f64_start(world), CAROM_ERROR_OVERLAP, "it overlaps the wall");
}

static void text(carom_world_3d_f64 *world) {
  char all[200], some[6] = "?????";
  expect(carom_3d_f64_error_text(world, all, sizeof all), CAROM_OK, "the text");
  if (strstr(all, "grain 1 and plane 1 overlap") != all) wrong = 1, printf("the text is: %s\n", all);
  expect(carom_3d_f64_error_text(world, some, 0), CAROM_ERROR_LENGTH, "a text of no bytes");
  expect(carom_3d_f64_error_text(world, some, 5), CAROM_OK, "a text of five bytes");
  if (memcmp(some, "grai", 5) != 0) wrong = 1, printf("the short text is: %s\n", some);
}

static void running(carom_world_3d_f64 *world) {
  const double low[3] = {0.0, 0.0, 0.0}, high[3] = {1.0, 1.0, 1.0}, nan3[3] = {(double)NAN, 0.0, 0.0};
  carom_grain_3d_f64 grain = {{0.5, 0.5, 0.5}, {1.0, 0.5, 0.25}, 0.1, 1.0};
  double numbers[3] = {7.0, 7.0, 7.0};
  expect(carom_3d_f64_create(memory, sizeof memory, 1, 6, &world), CAROM_OK, "again");
  expect(carom_3d_f64_set_restitution(world, 1.0), CAROM_OK, "its law");
  expect(carom_3d_f64_add_hard_walls(world, low, high, 1.0), CAROM_OK, "its walls");
  expect(carom_3d_f64_add_grain(world, &grain), CAROM_OK, "its grain");
  expect(carom_3d_f64_add_grain(world, &grain), CAROM_ERROR_FULL, "one too many");
  expect(carom_3d_f64_start(world), CAROM_OK, "its start");
  keep();
  expect(carom_3d_f64_start(world), CAROM_ERROR_STARTED, "a second start");
  expect(carom_3d_f64_grain(world, 1, &grain), CAROM_ERROR_INDEX, "grain 1 of one");
  expect(carom_3d_f64_set_velocity(world, 1, low), CAROM_ERROR_INDEX, "the velocity of grain 1");
  expect(carom_3d_f64_positions(world, numbers, 2), CAROM_ERROR_LENGTH, "two places for three numbers");
  expect(carom_3d_f64_save(world, snapshot, 64), CAROM_ERROR_MEMORY, "64 bytes for a snapshot");
  expect(carom_3d_f64_save(world, snapshot + 4, 2048), CAROM_ERROR_MISALIGNED, "a snapshot 4 bytes off");
  expect(carom_3d_f64_restore(world, snapshot), CAROM_ERROR_NO_WORLD, "zeros are no snapshot");
  expect_untouched("running");
  if (numbers[0] != 7.0 || numbers[2] != 7.0) wrong = 1, printf("positions were written\n");
  expect(carom_3d_f64_set_velocity(world, 0, nan3), CAROM_ERROR_INPUT, "a velocity that is none");
  expect(carom_3d_f64_advance_to(world, (double)NAN), CAROM_ERROR_INPUT, "until when?");
  expect(carom_3d_f64_advance_by(world, -1.0), CAROM_ERROR_INPUT, "back");
  expect(carom_3d_f64_advance_to(world, -1.0), CAROM_ERROR_PAST, "into the past");
  expect(carom_3d_f64_advance_by(world, 1.0), CAROM_OK, "a second");
}

int main(void) {
  carom_world_3d_f64 *world = NULL;
  creation();
  expect(carom_3d_f64_create(memory, sizeof memory, 8, 6, &world), CAROM_OK, "create");
  description(world);
  text(world);
  running(world);
  if (!wrong) printf("bad input from C: all refused\n");
  return wrong;
}
