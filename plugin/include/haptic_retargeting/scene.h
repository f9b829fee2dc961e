/*
 * Scenes: plate, start and targets out of a glTF file that a designer made; scene/README.md tells how. Load,
 * register with a session, destroy.
 */
#ifndef HAPTIC_RETARGETING_SCENE_H
#define HAPTIC_RETARGETING_SCENE_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A scene's handle. Zero is never a scene. A handle of a destroyed scene is never valid again. */
typedef struct hrt_scene {
  uint64_t value;
} hrt_scene;

/** Scenes that can be loaded at the same time in a process. */
#define HRT_SCENES_MAX 64

/** The plate of a scene. Set `struct_size` before the call. */
typedef struct hrt_scene_info {
  uint32_t struct_size;
  /** How many targets the scene has, real and virtual. */
  uint32_t target_count;
  /** The plate in the world, as in hrt_session_config. */
  double plate_position_m[3];
  double plate_rotation[4];
  double plate_radius_m;
  /** Of the plate's servo; 0 if the file does not tell. */
  double plate_max_speed_deg_s;
  /** In plate coordinates. */
  double start_position_m[3];
} hrt_scene_info;

/** A target of a scene. Set `struct_size` before the call. */
typedef struct hrt_scene_target {
  uint32_t struct_size;
  /** HRT_TARGET_*. */
  uint32_t role;
  /** Of a virtual target: the index of the real one that serves it; of a real one -1. */
  int32_t served_by;
  uint32_t reserved;
  /** In plate coordinates; y is the height above the plate. */
  double position_m[3];
  double world_position_m[3];
  /** Seen from the start, along the plate. */
  double direction_deg;
  double distance_m;
  /** 0 if the file does not tell. */
  double radius_m;
  char name[HRT_NAME_SIZE];
} hrt_scene_target;

/** Loads a .gltf or .glb file. Errors: BAD_FORMAT naming the file, the node and the property, LIMIT_REACHED.
 *  If memory runs out while a file is read, the process may end: the JSON library underneath allocates when
 *  it cleans up. [any-thread] */
HRT_API hrt_result hrt_scene_load_file(const char* path, hrt_scene* out_scene) HRT_NOEXCEPT;

/** The same from memory, which is not used after the call. `name` stands for the file in error texts.
 *  [any-thread] */
HRT_API hrt_result hrt_scene_load_memory(const void* bytes, uint64_t length, const char* name,
                                         hrt_scene* out_scene) HRT_NOEXCEPT;

/** Forgets the scene; what was registered from it stays. Errors of this and the calls below: INVALID_HANDLE,
 *  and BUSY if another thread is in a call on this scene. [one-thread] */
HRT_API hrt_result hrt_scene_destroy(hrt_scene scene) HRT_NOEXCEPT;

/** [one-thread] */
HRT_API hrt_result hrt_scene_get_info(hrt_scene scene, hrt_scene_info* out_info) HRT_NOEXCEPT;

/** The target of an index below hrt_scene_info::target_count. Errors: OUT_OF_RANGE. [one-thread] */
HRT_API hrt_result hrt_scene_get_target(hrt_scene scene, uint32_t index,
                                        hrt_scene_target* out_target) HRT_NOEXCEPT;

/** Sets the session's plate, start and, if the file tells it, the servo's highest speed, and adds all targets
 *  by their place on the plate. Their ids go to `out_targets` in the order of the scene; it may be null if
 *  `capacity` is 0. Errors, at which nothing is added: BUFFER_TOO_SMALL, NAME_TAKEN, WRONG_STATE during a
 *  reach. [one-thread] for both. */
HRT_API hrt_result hrt_scene_register(hrt_scene scene, hrt_session session, uint32_t capacity,
                                      hrt_target* out_targets) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
