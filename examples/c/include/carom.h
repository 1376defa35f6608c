// carom from C and C++: what can be called. Made by cbindgen from Rust: do not edit, see README.md.

#ifndef CAROM_H
#define CAROM_H



#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
// The memory of a world or a snapshot begins at a multiple of this.
#define CAROM_ALIGNMENT (sizeof(void *) > 4 ? CAROM_ALIGNMENT_64 : CAROM_ALIGNMENT_32)

// How many bytes a world of so many grains and planes takes at most: a constant, so that its memory can be static.
#define CAROM_2D_F32_BYTES(grains, planes) CAROM_BYTES_OF(2D_F32, grains, planes)
#define CAROM_2D_F64_BYTES(grains, planes) CAROM_BYTES_OF(2D_F64, grains, planes)
#define CAROM_3D_F64_BYTES(grains, planes) CAROM_BYTES_OF(3D_F64, grains, planes)
#define CAROM_BYTES_OF(KIND, grains, planes) \
  (sizeof(void *) > 4 ? CAROM_##KIND##_FIXED_64 + (size_t)(grains) * CAROM_##KIND##_GRAIN_64 \
                                                + (size_t)(planes) * CAROM_##KIND##_PLANE_64 \
                      : CAROM_##KIND##_FIXED_32 + (size_t)(grains) * CAROM_##KIND##_GRAIN_32 \
                                                + (size_t)(planes) * CAROM_##KIND##_PLANE_32)

// So many bytes that a world or a snapshot can lie in, as in
//     static CAROM_MEMORY(memory, CAROM_2D_F32_BYTES(16, 4));
#if defined(__cplusplus)
#define CAROM_MEMORY(name, bytes) unsigned char name alignas(CAROM_ALIGNMENT)[bytes]
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define CAROM_MEMORY(name, bytes) _Alignas(CAROM_ALIGNMENT) unsigned char name[bytes]
#else
#define CAROM_MEMORY(name, bytes) unsigned char name[bytes] __attribute__((aligned(64)))
#endif


// The alignment that the memory of worlds and snapshots must have where pointers have 64 bits.
#define CAROM_ALIGNMENT_64 64

// The same where they have 32.
#define CAROM_ALIGNMENT_32 8

// Bytes of such a world without grains and planes where pointers have 32 bits.
#define CAROM_2D_F32_FIXED_32 704

// Bytes of each grain there.
#define CAROM_2D_F32_GRAIN_32 96

// Bytes of each plane there.
#define CAROM_2D_F32_PLANE_32 64

// Bytes of such a world without grains and planes where pointers have 64 bits.
#define CAROM_2D_F32_FIXED_64 1024

// Bytes of each grain there.
#define CAROM_2D_F32_GRAIN_64 100

// Bytes of each plane there.
#define CAROM_2D_F32_PLANE_64 64

// Bytes of such a world without grains and planes where pointers have 32 bits.
#define CAROM_2D_F64_FIXED_32 896

// Bytes of each grain there.
#define CAROM_2D_F64_GRAIN_32 160

// Bytes of each plane there.
#define CAROM_2D_F64_PLANE_32 128

// Bytes of such a world without grains and planes where pointers have 64 bits.
#define CAROM_2D_F64_FIXED_64 1152

// Bytes of each grain there.
#define CAROM_2D_F64_GRAIN_64 184

// Bytes of each plane there.
#define CAROM_2D_F64_PLANE_64 128

// Bytes of such a world without grains and planes where pointers have 32 bits.
#define CAROM_3D_F64_FIXED_32 960

// Bytes of each grain there.
#define CAROM_3D_F64_GRAIN_32 192

// Bytes of each plane there.
#define CAROM_3D_F64_PLANE_32 136

// Bytes of such a world without grains and planes where pointers have 64 bits.
#define CAROM_3D_F64_FIXED_64 1216

// Bytes of each grain there.
#define CAROM_3D_F64_GRAIN_64 192

// Bytes of each plane there.
#define CAROM_3D_F64_PLANE_64 136

// The compact tables: about 2 KB a law, errors up to 1.5e-4.
#define CAROM_TABLE_COMPACT 0

// The standard tables: about 20 KB a law, errors up to 1.1e-6. The library has them if it was built with them.
#define CAROM_TABLE_STANDARD 1

// The default: contacts that last or crowd are integrated.
#define CAROM_MODE_INTEGRATED 0

// The papers' mode: one contact of two after the other, grains at rest by rules. The library has it if it was built with
// it (feature paper): 30 KB of flash more.
#define CAROM_MODE_PAPER 1

// There is no such grain, or no such plane.
#define CAROM_NOBODY 4294967295

// What a call says: CAROM_OK, or why nothing was done.
enum carom_error
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // It is done.
  CAROM_OK = 0,
  // A pointer is NULL.
  CAROM_ERROR_NULL = 1,
  // A pointer has not the alignment of what it points to; the memory of a world has CAROM_ALIGNMENT.
  CAROM_ERROR_MISALIGNED = 2,
  // The memory is too small for so many grains and planes, or for a snapshot.
  CAROM_ERROR_MEMORY = 3,
  // The pointer is that of no world, or snapshot, of this kind.
  CAROM_ERROR_NO_WORLD = 4,
  // The world has not been started yet.
  CAROM_ERROR_NOT_STARTED = 5,
  // The world has been started: it cannot be described any longer.
  CAROM_ERROR_STARTED = 6,
  // There is no grain of this number.
  CAROM_ERROR_INDEX = 7,
  // The array is too short.
  CAROM_ERROR_LENGTH = 8,
  // The library was built without this table.
  CAROM_ERROR_TABLE = 9,
  // A number cannot be what it is: the text of the error says which, and what would be right.
  CAROM_ERROR_INPUT = 10,
  // There is no place for another grain or plane.
  CAROM_ERROR_FULL = 11,
  // Two grains, or a grain and a plane, overlap at the start.
  CAROM_ERROR_OVERLAP = 12,
  // A collision lies outside the table's domain.
  CAROM_ERROR_OUTSIDE_TABLE = 13,
  // The contact time is so long that a grain at rest would sink in by more than a twentieth of its radius.
  CAROM_ERROR_LONG_CONTACT = 14,
  // The law gave something that is not the outcome of a collision.
  CAROM_ERROR_OUTCOME = 15,
  // Too many events at one instant.
  CAROM_ERROR_STUCK = 16,
  // A grain's state has left the range of its number.
  CAROM_ERROR_NOT_FINITE = 17,
  // The time asked for lies in the past.
  CAROM_ERROR_PAST = 18,
  // A number does not fit the fixed-point type. No world of this library has one.
  CAROM_ERROR_OVERFLOW = 19,
  // The library was built without this mode, or there is none of this number.
  CAROM_ERROR_MODE = 20,
  // Another error: the text says which.
  CAROM_ERROR_OTHER = 21,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_error carom_error;
#else
typedef int32_t carom_error;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What an event was.
enum carom_event_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // Nothing happened until the time that was asked for.
  CAROM_EVENT_NONE = 0,
  // A grain touched another, or a plane.
  CAROM_EVENT_COLLISION = 1,
  // A contact of two ended.
  CAROM_EVENT_CONTACT_END = 2,
  // Grains that touch several others moved a step on.
  CAROM_EVENT_STEP = 3,
  // Something else that changes how a grain moves.
  CAROM_EVENT_OTHER = 4,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_event_kind carom_event_kind;
#else
typedef int32_t carom_event_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What becomes of contacts that last or crowd.
typedef struct Mode Mode;

//A world of disks whose numbers are float. It lies in memory that the caller gives.
typedef struct carom_world_2d_f32 carom_world_2d_f32;

//A world of disks whose numbers are double. It lies in memory that the caller gives.
typedef struct carom_world_2d_f64 carom_world_2d_f64;

//A world of spheres whose numbers are double. It lies in memory that the caller gives.
typedef struct carom_world_3d_f64 carom_world_3d_f64;

//One of disks whose numbers are float.
typedef struct carom_grain_2d_f32 {
  // Centre.
  float position[2];
  // Velocity of the centre.
  float velocity[2];
  // Radius, above 0.
  float radius;
  // Mass, above 0.
  float mass;
} carom_grain_2d_f32;

// One event.
typedef struct carom_event {
  // When, in units of time since the start.
  double time;
  // What it was.
  carom_event_kind kind;
  // To which grain; CAROM_NOBODY if nothing happened.
  uint32_t grain;
  // With which other grain, or CAROM_NOBODY.
  uint32_t other;
  // With which plane, or CAROM_NOBODY.
  uint32_t plane;
} carom_event;

// How often what happened.
typedef struct carom_statistics {
  // Contacts of two grains that began, and instantaneous collisions of two.
  uint64_t collisions;
  // The same with planes.
  uint64_t plane_collisions;
  // Contacts of two that ended at their time: one for each grain.
  uint64_t releases;
  // Impacts outside the table's domain, answered by the hard-sphere rule.
  uint64_t hard_sphere;
  // Times that a grain began to be moved by the forces of all that it touches.
  uint64_t joins;
  // Steps of such grains.
  uint64_t steps;
  // Steps in which some two were crushed.
  uint64_t crushed;
  // Flights into another cell.
  uint64_t cell_crossings;
} carom_statistics;

//One of disks whose numbers are double.
typedef struct carom_grain_2d_f64 {
  // Centre.
  double position[2];
  // Velocity of the centre.
  double velocity[2];
  // Radius, above 0.
  double radius;
  // Mass, above 0.
  double mass;
} carom_grain_2d_f64;

//One of spheres whose numbers are double.
typedef struct carom_grain_3d_f64 {
  // Centre.
  double position[3];
  // Velocity of the centre.
  double velocity[3];
  // Radius, above 0.
  double radius;
  // Mass, above 0.
  double mass;
} carom_grain_3d_f64;



#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The name of a code, such as "CAROM_ERROR_NULL": a text that is always there.
const char *carom_error_name(int32_t error);

// What a code means, in one sentence: a text that is always there.
const char *carom_error_meaning(int32_t error);

// How many bytes a world of so many grains and planes takes; 0 if there cannot be one. It is not more
// than the macro of the same name says, which can be used for a static array.
size_t carom_2d_f32_bytes(uint32_t grains, uint32_t planes);

// Makes an empty world in this memory, with places for so many grains and at most 8 planes. What was there
// before, a world too, is gone.
carom_error carom_2d_f32_create(void *memory,
                                size_t bytes,
                                uint32_t grains,
                                uint32_t planes,
                                struct carom_world_2d_f32 **world);

// The law of hard grains: this constant coefficient of restitution, from 0 to 1.
carom_error carom_2d_f32_set_restitution(struct carom_world_2d_f32 *world, float restitution);

// The law of linear spring-dashpots (stiffness: force over length, damping: force over speed), with one of
// the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
carom_error carom_2d_f32_set_linear_dashpot(struct carom_world_2d_f32 *world,
                                            float stiffness,
                                            float damping,
                                            int32_t table);

// The law of viscoelastic spheres (Young's modulus, Poisson's ratio, the dissipative constant A: a time),
// with one of the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
carom_error carom_2d_f32_set_viscoelastic(struct carom_world_2d_f32 *world,
                                          float young,
                                          float poisson,
                                          float dissipation,
                                          int32_t table);

//A box of walls from low to high, 2 numbers each; the law says what they do. All of them, or none.
carom_error carom_2d_f32_add_walls(struct carom_world_2d_f32 *world, const float *low, const float *high);

//A box of hard walls of this coefficient of restitution from low to high, 2 numbers each. All of them, or none.
carom_error carom_2d_f32_add_hard_walls(struct carom_world_2d_f32 *world,
                                        const float *low,
                                        const float *high,
                                        float restitution);

//A plane. Grains stay where normal . r >= offset; the normal, 2 numbers, has the length 1. The law says what it does.
carom_error carom_2d_f32_add_plane(struct carom_world_2d_f32 *world,
                                   const float *normal,
                                   float offset);

// A hard plane of this coefficient of restitution.
carom_error carom_2d_f32_add_hard_plane(struct carom_world_2d_f32 *world,
                                        const float *normal,
                                        float offset,
                                        float restitution);

// A hard plane that vibrates along its normal about its offset, with this amplitude and frequency (cycles
// per unit of time).
carom_error carom_2d_f32_add_plate(struct carom_world_2d_f32 *world,
                                   const float *normal,
                                   float offset,
                                   float restitution,
                                   float amplitude,
                                   float frequency);

// Makes an axis periodic, from low to high. Its length is at least 4.5 times the largest radius.
carom_error carom_2d_f32_set_periodic(struct carom_world_2d_f32 *world, uint32_t axis, float low, float high);

//Gravity, 2 numbers: before the start, and at any time after it.
carom_error carom_2d_f32_set_gravity(struct carom_world_2d_f32 *world, const float *gravity);

// How long slow contacts of hard grains last; by default a sixteenth of the square root of R / g.
carom_error carom_2d_f32_set_contact_time(struct carom_world_2d_f32 *world, float time);

// In how many steps the shortest contact of several grains is integrated: from 8 to 131072, by default 32.
carom_error carom_2d_f32_set_steps_per_contact(struct carom_world_2d_f32 *world, uint32_t steps);

// CAROM_MODE_INTEGRATED, the default, or CAROM_MODE_PAPER, if the library has it.
carom_error carom_2d_f32_set_mode(struct carom_world_2d_f32 *world, int32_t mode);

// So many empty places, behind the grains so far, for grains that are inserted while time passes. Of the
// places that create was told of.
carom_error carom_2d_f32_add_empty_places(struct carom_world_2d_f32 *world, uint32_t places);

// One grain more. Grains are numbered from 0 in the order in which they are added.
carom_error carom_2d_f32_add_grain(struct carom_world_2d_f32 *world, const struct carom_grain_2d_f32 *grain);

// The description is complete: everything is checked, and the world can run. If something is wrong it can
// still be described, and started then.
carom_error carom_2d_f32_start(struct carom_world_2d_f32 *world);

//Gives a grain another velocity, 2 numbers, now.
carom_error carom_2d_f32_set_velocity(struct carom_world_2d_f32 *world,
                                      uint32_t index,
                                      const float *velocity);

// One grain more, now, in the first empty place, whose number index is: CAROM_ERROR_FULL without one,
// CAROM_ERROR_OVERLAP where another body is. Its radius is at most the largest at the start.
carom_error carom_2d_f32_insert_grain(struct carom_world_2d_f32 *world,
                                      const struct carom_grain_2d_f32 *grain,
                                      uint32_t *index);

// Takes a grain out, now; grain is what it was. Its place is empty: the others keep their numbers.
carom_error carom_2d_f32_remove_grain(struct carom_world_2d_f32 *world,
                                      uint32_t index,
                                      struct carom_grain_2d_f32 *grain);

// Everything up to this time happens, and it becomes the present.
carom_error carom_2d_f32_advance_to(struct carom_world_2d_f32 *world, double time);

// So much time passes.
carom_error carom_2d_f32_advance_by(struct carom_world_2d_f32 *world, double time);

// As advance_to, but it stops after so many events; arrived says whether the time has come. Called again
// until it has, it ends in the same state to the last bit.
carom_error carom_2d_f32_advance_with_budget(struct carom_world_2d_f32 *world,
                                             double time,
                                             uint32_t events,
                                             bool *arrived);

// The next event that changes how a grain moves happens, if it is not later than this time; else the time
// becomes the present, and the event is CAROM_EVENT_NONE.
carom_error carom_2d_f32_step(struct carom_world_2d_f32 *world, double until, struct carom_event *event);

// The present.
carom_error carom_2d_f32_time(struct carom_world_2d_f32 *world, double *time);

// Nothing happens before this time: one can sleep until then. Infinite if nothing will ever happen.
carom_error carom_2d_f32_next_event_time(struct carom_world_2d_f32 *world, double *time);

// How many grains there are, empty places included: an array of so many holds something of each.
carom_error carom_2d_f32_count(struct carom_world_2d_f32 *world, uint32_t *count);

// A grain as it is now; CAROM_ERROR_INDEX for an empty place.
carom_error carom_2d_f32_grain(struct carom_world_2d_f32 *world,
                               uint32_t index,
                               struct carom_grain_2d_f32 *grain);

//All positions, 2 numbers for each grain, 0 for empty places; length is how many numbers there are places for.
carom_error carom_2d_f32_positions(struct carom_world_2d_f32 *world,
                                   float *positions,
                                   size_t length);

//All velocities, 2 numbers for each grain, 0 for empty places; length is how many numbers there are places for.
carom_error carom_2d_f32_velocities(struct carom_world_2d_f32 *world,
                                    float *velocities,
                                    size_t length);

// The kinetic energy, contacts under way counted as if they ended now.
carom_error carom_2d_f32_kinetic_energy(struct carom_world_2d_f32 *world, float *energy);

//The momentum, 2 numbers.
carom_error carom_2d_f32_momentum(struct carom_world_2d_f32 *world, float *momentum);

// A digest of the whole state: equal states have equal digests on every target and in every language.
carom_error carom_2d_f32_digest(struct carom_world_2d_f32 *world, uint64_t *digest);

// How often what happened since the start.
carom_error carom_2d_f32_statistics(struct carom_world_2d_f32 *world, struct carom_statistics *statistics);

// How many bytes a snapshot of this world takes.
carom_error carom_2d_f32_saved_bytes(struct carom_world_2d_f32 *world, size_t *bytes);

// Writes a snapshot of the world into this memory, which has CAROM_ALIGNMENT, too. Another run of the
// program cannot read it.
carom_error carom_2d_f32_save(struct carom_world_2d_f32 *world, void *memory, size_t bytes);

// Brings this world into the state of a snapshot, of this world or another; it goes on with the same bits.
// It must have places for as many grains and planes.
carom_error carom_2d_f32_restore(struct carom_world_2d_f32 *world, const void *saved);

// Writes the text of this world's last error, in words: which field is wrong, its value, and what would be
// right. It ends with a zero; what does not fit into so many bytes, at least one, is left out. Empty if
// there was no error.
carom_error carom_2d_f32_error_text(struct carom_world_2d_f32 *world, char *text, size_t bytes);

// How many bytes a world of so many grains and planes takes; 0 if there cannot be one. It is not more
// than the macro of the same name says, which can be used for a static array.
size_t carom_2d_f64_bytes(uint32_t grains, uint32_t planes);

// Makes an empty world in this memory, with places for so many grains and at most 8 planes. What was there
// before, a world too, is gone.
carom_error carom_2d_f64_create(void *memory,
                                size_t bytes,
                                uint32_t grains,
                                uint32_t planes,
                                struct carom_world_2d_f64 **world);

// The law of hard grains: this constant coefficient of restitution, from 0 to 1.
carom_error carom_2d_f64_set_restitution(struct carom_world_2d_f64 *world, double restitution);

// The law of linear spring-dashpots (stiffness: force over length, damping: force over speed), with one of
// the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
carom_error carom_2d_f64_set_linear_dashpot(struct carom_world_2d_f64 *world,
                                            double stiffness,
                                            double damping,
                                            int32_t table);

// The law of viscoelastic spheres (Young's modulus, Poisson's ratio, the dissipative constant A: a time),
// with one of the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
carom_error carom_2d_f64_set_viscoelastic(struct carom_world_2d_f64 *world,
                                          double young,
                                          double poisson,
                                          double dissipation,
                                          int32_t table);

//A box of walls from low to high, 2 numbers each; the law says what they do. All of them, or none.
carom_error carom_2d_f64_add_walls(struct carom_world_2d_f64 *world, const double *low, const double *high);

//A box of hard walls of this coefficient of restitution from low to high, 2 numbers each. All of them, or none.
carom_error carom_2d_f64_add_hard_walls(struct carom_world_2d_f64 *world,
                                        const double *low,
                                        const double *high,
                                        double restitution);

//A plane. Grains stay where normal . r >= offset; the normal, 2 numbers, has the length 1. The law says what it does.
carom_error carom_2d_f64_add_plane(struct carom_world_2d_f64 *world,
                                   const double *normal,
                                   double offset);

// A hard plane of this coefficient of restitution.
carom_error carom_2d_f64_add_hard_plane(struct carom_world_2d_f64 *world,
                                        const double *normal,
                                        double offset,
                                        double restitution);

// A hard plane that vibrates along its normal about its offset, with this amplitude and frequency (cycles
// per unit of time).
carom_error carom_2d_f64_add_plate(struct carom_world_2d_f64 *world,
                                   const double *normal,
                                   double offset,
                                   double restitution,
                                   double amplitude,
                                   double frequency);

// Makes an axis periodic, from low to high. Its length is at least 4.5 times the largest radius.
carom_error carom_2d_f64_set_periodic(struct carom_world_2d_f64 *world,
                                      uint32_t axis,
                                      double low,
                                      double high);

//Gravity, 2 numbers: before the start, and at any time after it.
carom_error carom_2d_f64_set_gravity(struct carom_world_2d_f64 *world, const double *gravity);

// How long slow contacts of hard grains last; by default a sixteenth of the square root of R / g.
carom_error carom_2d_f64_set_contact_time(struct carom_world_2d_f64 *world, double time);

// In how many steps the shortest contact of several grains is integrated: from 8 to 131072, by default 32.
carom_error carom_2d_f64_set_steps_per_contact(struct carom_world_2d_f64 *world, uint32_t steps);

// CAROM_MODE_INTEGRATED, the default, or CAROM_MODE_PAPER, if the library has it.
carom_error carom_2d_f64_set_mode(struct carom_world_2d_f64 *world, int32_t mode);

// So many empty places, behind the grains so far, for grains that are inserted while time passes. Of the
// places that create was told of.
carom_error carom_2d_f64_add_empty_places(struct carom_world_2d_f64 *world, uint32_t places);

// One grain more. Grains are numbered from 0 in the order in which they are added.
carom_error carom_2d_f64_add_grain(struct carom_world_2d_f64 *world, const struct carom_grain_2d_f64 *grain);

// The description is complete: everything is checked, and the world can run. If something is wrong it can
// still be described, and started then.
carom_error carom_2d_f64_start(struct carom_world_2d_f64 *world);

//Gives a grain another velocity, 2 numbers, now.
carom_error carom_2d_f64_set_velocity(struct carom_world_2d_f64 *world,
                                      uint32_t index,
                                      const double *velocity);

// One grain more, now, in the first empty place, whose number index is: CAROM_ERROR_FULL without one,
// CAROM_ERROR_OVERLAP where another body is. Its radius is at most the largest at the start.
carom_error carom_2d_f64_insert_grain(struct carom_world_2d_f64 *world,
                                      const struct carom_grain_2d_f64 *grain,
                                      uint32_t *index);

// Takes a grain out, now; grain is what it was. Its place is empty: the others keep their numbers.
carom_error carom_2d_f64_remove_grain(struct carom_world_2d_f64 *world,
                                      uint32_t index,
                                      struct carom_grain_2d_f64 *grain);

// Everything up to this time happens, and it becomes the present.
carom_error carom_2d_f64_advance_to(struct carom_world_2d_f64 *world, double time);

// So much time passes.
carom_error carom_2d_f64_advance_by(struct carom_world_2d_f64 *world, double time);

// As advance_to, but it stops after so many events; arrived says whether the time has come. Called again
// until it has, it ends in the same state to the last bit.
carom_error carom_2d_f64_advance_with_budget(struct carom_world_2d_f64 *world,
                                             double time,
                                             uint32_t events,
                                             bool *arrived);

// The next event that changes how a grain moves happens, if it is not later than this time; else the time
// becomes the present, and the event is CAROM_EVENT_NONE.
carom_error carom_2d_f64_step(struct carom_world_2d_f64 *world, double until, struct carom_event *event);

// The present.
carom_error carom_2d_f64_time(struct carom_world_2d_f64 *world, double *time);

// Nothing happens before this time: one can sleep until then. Infinite if nothing will ever happen.
carom_error carom_2d_f64_next_event_time(struct carom_world_2d_f64 *world, double *time);

// How many grains there are, empty places included: an array of so many holds something of each.
carom_error carom_2d_f64_count(struct carom_world_2d_f64 *world, uint32_t *count);

// A grain as it is now; CAROM_ERROR_INDEX for an empty place.
carom_error carom_2d_f64_grain(struct carom_world_2d_f64 *world,
                               uint32_t index,
                               struct carom_grain_2d_f64 *grain);

//All positions, 2 numbers for each grain, 0 for empty places; length is how many numbers there are places for.
carom_error carom_2d_f64_positions(struct carom_world_2d_f64 *world,
                                   double *positions,
                                   size_t length);

//All velocities, 2 numbers for each grain, 0 for empty places; length is how many numbers there are places for.
carom_error carom_2d_f64_velocities(struct carom_world_2d_f64 *world,
                                    double *velocities,
                                    size_t length);

// The kinetic energy, contacts under way counted as if they ended now.
carom_error carom_2d_f64_kinetic_energy(struct carom_world_2d_f64 *world, double *energy);

//The momentum, 2 numbers.
carom_error carom_2d_f64_momentum(struct carom_world_2d_f64 *world, double *momentum);

// A digest of the whole state: equal states have equal digests on every target and in every language.
carom_error carom_2d_f64_digest(struct carom_world_2d_f64 *world, uint64_t *digest);

// How often what happened since the start.
carom_error carom_2d_f64_statistics(struct carom_world_2d_f64 *world, struct carom_statistics *statistics);

// How many bytes a snapshot of this world takes.
carom_error carom_2d_f64_saved_bytes(struct carom_world_2d_f64 *world, size_t *bytes);

// Writes a snapshot of the world into this memory, which has CAROM_ALIGNMENT, too. Another run of the
// program cannot read it.
carom_error carom_2d_f64_save(struct carom_world_2d_f64 *world, void *memory, size_t bytes);

// Brings this world into the state of a snapshot, of this world or another; it goes on with the same bits.
// It must have places for as many grains and planes.
carom_error carom_2d_f64_restore(struct carom_world_2d_f64 *world, const void *saved);

// Writes the text of this world's last error, in words: which field is wrong, its value, and what would be
// right. It ends with a zero; what does not fit into so many bytes, at least one, is left out. Empty if
// there was no error.
carom_error carom_2d_f64_error_text(struct carom_world_2d_f64 *world, char *text, size_t bytes);

// How many bytes a world of so many grains and planes takes; 0 if there cannot be one. It is not more
// than the macro of the same name says, which can be used for a static array.
size_t carom_3d_f64_bytes(uint32_t grains, uint32_t planes);

// Makes an empty world in this memory, with places for so many grains and at most 8 planes. What was there
// before, a world too, is gone.
carom_error carom_3d_f64_create(void *memory,
                                size_t bytes,
                                uint32_t grains,
                                uint32_t planes,
                                struct carom_world_3d_f64 **world);

// The law of hard grains: this constant coefficient of restitution, from 0 to 1.
carom_error carom_3d_f64_set_restitution(struct carom_world_3d_f64 *world, double restitution);

// The law of linear spring-dashpots (stiffness: force over length, damping: force over speed), with one of
// the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
carom_error carom_3d_f64_set_linear_dashpot(struct carom_world_3d_f64 *world,
                                            double stiffness,
                                            double damping,
                                            int32_t table);

// The law of viscoelastic spheres (Young's modulus, Poisson's ratio, the dissipative constant A: a time),
// with one of the tables CAROM_TABLE_COMPACT and CAROM_TABLE_STANDARD.
carom_error carom_3d_f64_set_viscoelastic(struct carom_world_3d_f64 *world,
                                          double young,
                                          double poisson,
                                          double dissipation,
                                          int32_t table);

//A box of walls from low to high, 3 numbers each; the law says what they do. All of them, or none.
carom_error carom_3d_f64_add_walls(struct carom_world_3d_f64 *world, const double *low, const double *high);

//A box of hard walls of this coefficient of restitution from low to high, 3 numbers each. All of them, or none.
carom_error carom_3d_f64_add_hard_walls(struct carom_world_3d_f64 *world,
                                        const double *low,
                                        const double *high,
                                        double restitution);

//A plane. Grains stay where normal . r >= offset; the normal, 3 numbers, has the length 1. The law says what it does.
carom_error carom_3d_f64_add_plane(struct carom_world_3d_f64 *world,
                                   const double *normal,
                                   double offset);

// A hard plane of this coefficient of restitution.
carom_error carom_3d_f64_add_hard_plane(struct carom_world_3d_f64 *world,
                                        const double *normal,
                                        double offset,
                                        double restitution);

// A hard plane that vibrates along its normal about its offset, with this amplitude and frequency (cycles
// per unit of time).
carom_error carom_3d_f64_add_plate(struct carom_world_3d_f64 *world,
                                   const double *normal,
                                   double offset,
                                   double restitution,
                                   double amplitude,
                                   double frequency);

// Makes an axis periodic, from low to high. Its length is at least 4.5 times the largest radius.
carom_error carom_3d_f64_set_periodic(struct carom_world_3d_f64 *world,
                                      uint32_t axis,
                                      double low,
                                      double high);

//Gravity, 3 numbers: before the start, and at any time after it.
carom_error carom_3d_f64_set_gravity(struct carom_world_3d_f64 *world, const double *gravity);

// How long slow contacts of hard grains last; by default a sixteenth of the square root of R / g.
carom_error carom_3d_f64_set_contact_time(struct carom_world_3d_f64 *world, double time);

// In how many steps the shortest contact of several grains is integrated: from 8 to 131072, by default 32.
carom_error carom_3d_f64_set_steps_per_contact(struct carom_world_3d_f64 *world, uint32_t steps);

// CAROM_MODE_INTEGRATED, the default, or CAROM_MODE_PAPER, if the library has it.
carom_error carom_3d_f64_set_mode(struct carom_world_3d_f64 *world, int32_t mode);

// So many empty places, behind the grains so far, for grains that are inserted while time passes. Of the
// places that create was told of.
carom_error carom_3d_f64_add_empty_places(struct carom_world_3d_f64 *world, uint32_t places);

// One grain more. Grains are numbered from 0 in the order in which they are added.
carom_error carom_3d_f64_add_grain(struct carom_world_3d_f64 *world, const struct carom_grain_3d_f64 *grain);

// The description is complete: everything is checked, and the world can run. If something is wrong it can
// still be described, and started then.
carom_error carom_3d_f64_start(struct carom_world_3d_f64 *world);

//Gives a grain another velocity, 3 numbers, now.
carom_error carom_3d_f64_set_velocity(struct carom_world_3d_f64 *world,
                                      uint32_t index,
                                      const double *velocity);

// One grain more, now, in the first empty place, whose number index is: CAROM_ERROR_FULL without one,
// CAROM_ERROR_OVERLAP where another body is. Its radius is at most the largest at the start.
carom_error carom_3d_f64_insert_grain(struct carom_world_3d_f64 *world,
                                      const struct carom_grain_3d_f64 *grain,
                                      uint32_t *index);

// Takes a grain out, now; grain is what it was. Its place is empty: the others keep their numbers.
carom_error carom_3d_f64_remove_grain(struct carom_world_3d_f64 *world,
                                      uint32_t index,
                                      struct carom_grain_3d_f64 *grain);

// Everything up to this time happens, and it becomes the present.
carom_error carom_3d_f64_advance_to(struct carom_world_3d_f64 *world, double time);

// So much time passes.
carom_error carom_3d_f64_advance_by(struct carom_world_3d_f64 *world, double time);

// As advance_to, but it stops after so many events; arrived says whether the time has come. Called again
// until it has, it ends in the same state to the last bit.
carom_error carom_3d_f64_advance_with_budget(struct carom_world_3d_f64 *world,
                                             double time,
                                             uint32_t events,
                                             bool *arrived);

// The next event that changes how a grain moves happens, if it is not later than this time; else the time
// becomes the present, and the event is CAROM_EVENT_NONE.
carom_error carom_3d_f64_step(struct carom_world_3d_f64 *world, double until, struct carom_event *event);

// The present.
carom_error carom_3d_f64_time(struct carom_world_3d_f64 *world, double *time);

// Nothing happens before this time: one can sleep until then. Infinite if nothing will ever happen.
carom_error carom_3d_f64_next_event_time(struct carom_world_3d_f64 *world, double *time);

// How many grains there are, empty places included: an array of so many holds something of each.
carom_error carom_3d_f64_count(struct carom_world_3d_f64 *world, uint32_t *count);

// A grain as it is now; CAROM_ERROR_INDEX for an empty place.
carom_error carom_3d_f64_grain(struct carom_world_3d_f64 *world,
                               uint32_t index,
                               struct carom_grain_3d_f64 *grain);

//All positions, 3 numbers for each grain, 0 for empty places; length is how many numbers there are places for.
carom_error carom_3d_f64_positions(struct carom_world_3d_f64 *world,
                                   double *positions,
                                   size_t length);

//All velocities, 3 numbers for each grain, 0 for empty places; length is how many numbers there are places for.
carom_error carom_3d_f64_velocities(struct carom_world_3d_f64 *world,
                                    double *velocities,
                                    size_t length);

// The kinetic energy, contacts under way counted as if they ended now.
carom_error carom_3d_f64_kinetic_energy(struct carom_world_3d_f64 *world, double *energy);

//The momentum, 3 numbers.
carom_error carom_3d_f64_momentum(struct carom_world_3d_f64 *world, double *momentum);

// A digest of the whole state: equal states have equal digests on every target and in every language.
carom_error carom_3d_f64_digest(struct carom_world_3d_f64 *world, uint64_t *digest);

// How often what happened since the start.
carom_error carom_3d_f64_statistics(struct carom_world_3d_f64 *world, struct carom_statistics *statistics);

// How many bytes a snapshot of this world takes.
carom_error carom_3d_f64_saved_bytes(struct carom_world_3d_f64 *world, size_t *bytes);

// Writes a snapshot of the world into this memory, which has CAROM_ALIGNMENT, too. Another run of the
// program cannot read it.
carom_error carom_3d_f64_save(struct carom_world_3d_f64 *world, void *memory, size_t bytes);

// Brings this world into the state of a snapshot, of this world or another; it goes on with the same bits.
// It must have places for as many grains and planes.
carom_error carom_3d_f64_restore(struct carom_world_3d_f64 *world, const void *saved);

// Writes the text of this world's last error, in words: which field is wrong, its value, and what would be
// right. It ends with a zero; what does not fit into so many bytes, at least one, is left out. Empty if
// there was no error.
carom_error carom_3d_f64_error_text(struct carom_world_3d_f64 *world, char *text, size_t bytes);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CAROM_H */
