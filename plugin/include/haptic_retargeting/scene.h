/*
 * Scenes: plate, start and targets from a glTF file. scene/README.md, installed as scene.md, describes the file.
 *
 * Example: registers the targets of a file with a session.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <haptic_retargeting/scene.h>
 *
 *   // Returns the number of targets; -1 if the scene cannot be used, and hrt_last_error() has the reason.
 *   int use_scene(hrt_session session, const char* path, hrt_target* targets, uint64_t capacity) {
 *     hrt_scene scene;
 *     hrt_scene_info info = hrt_scene_info_init();
 *     if (hrt_scene_load(path, NULL, 0, &scene)) return -1;
 *     int failed = hrt_scene_register(scene, session, capacity, targets) || hrt_scene_get_info(scene, &info);
 *     hrt_scene_destroy(scene); // the session keeps the targets
 *     return failed ? -1 : (int)info.target_count;
 *   }
 */
#ifndef HAPTIC_RETARGETING_SCENE_H
#define HAPTIC_RETARGETING_SCENE_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A scene's handle. Zero is never a scene. Handles are never reused. */
typedef struct hrt_scene {
  uint64_t value;
} hrt_scene;

/** Maximum number of scenes in a process. */
#define HRT_SCENES_MAX 64

/** Plate of a scene, as the file describes it. */
typedef struct hrt_scene_info {
  uint32_t struct_size;
  /** Number of targets, real and virtual. */
  uint32_t target_count;
  /** Position of the plate in the world; see hrt_session_plate::position_m. */
  double plate_position_m[3];
  /** Rotation of the plate in the world; see hrt_session_plate::rotation. @unit 1 */
  double plate_rotation[4];
  /** Radius of the plate. */
  double plate_radius_m;
  /** Maximum speed of the servo; 0: not in the file. */
  double plate_max_speed_deg_s;
  /** Start of reaches, in plate coordinates. */
  double start_position_m[3];
} hrt_scene_info;

/** Target of a scene, as the file describes it. */
typedef struct hrt_scene_target {
  uint32_t struct_size;
  /** Role of the target. */
  hrt_target_role role;
  /** Index of the real target that is assigned to this virtual target: the target that the file names, or else the
   *  nearest in direction (of equally near ones, that with the smallest index). -1 for a real target. */
  int32_t served_by;
  uint32_t reserved;
  /** Position in plate coordinates; y is the height above the plate. */
  double position_m[3];
  /** Position in the engine's world. */
  double world_position_m[3];
  /** Direction from the start. @ccw */
  double direction_deg;
  /** Distance from the start along the plate. */
  double distance_m;
  /** Radius of the object; 0: not in the file. */
  double radius_m;
  /** Name of the target. UTF-8, terminated by a zero. */
  char name[HRT_NAME_SIZE];
} hrt_scene_target;

/** Loads a scene from a .gltf or .glb file or from memory. Logs a warning if targets are further than ten plate radii
 *  from the plate's centre: the file is probably not in metres. If memory is exhausted while the file is parsed, the
 *  process may end (PROCESS.md).
 *
 *  @param path       Name of the file, not null. If `bytes` is given, the name is used in messages only.
 *  @param bytes      Content of the file, not used after the call. Null: the file is read.
 *  @param length     Bytes of the content.
 *  @param out_scene  Handle of the scene.
 *  @return SYSTEM if the file cannot be read; BAD_FORMAT naming the file and, for a mistake in a node, the node;
 *          LIMIT_REACHED for more than HRT_SCENES_MAX scenes; OUT_OF_MEMORY.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_scene_load(const char* path, const void* bytes, uint64_t length,
                                                hrt_scene* out_scene) HRT_NOEXCEPT;

/** Destroys a scene. Targets that hrt_scene_register() has added to sessions are kept.
 *
 *  @threadsafety [one-thread] */
HRT_API hrt_result hrt_scene_destroy(hrt_scene scene) HRT_NOEXCEPT;

/** Returns the plate of a scene.
 *
 *  @param out_info  Plate, and number of targets.  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_scene_get_info(hrt_scene scene, hrt_scene_info* out_info) HRT_NOEXCEPT;

/** Returns a target of the scene.
 *
 *  @param index       Index of the target, below hrt_scene_info::target_count.
 *  @param out_target  Target.
 *  @return OUT_OF_RANGE naming the index.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_scene_get_target(hrt_scene scene, uint32_t index,
                                                      hrt_scene_target* out_target) HRT_NOEXCEPT;

/** Copies a scene into a session: sets the plate's pose and radius, the start and, if the file has one, the servo's
 *  speed; and adds all targets by their positions in plate coordinates, each virtual target with its
 *  hrt_target_config::served_by. A radius of a target above 1 m is stored as 1 m. Clears HRT_SESSION_REGISTERED,
 *  because the pose of the scene replaces the registered one.
 *
 *  @param capacity     Number of elements of `out_targets`.
 *  @param out_targets  Ids of the targets in the order of the scene. May be null if `capacity` is 0.
 *  @return BUFFER_TOO_SMALL; NAME_TAKEN; OUT_OF_RANGE if the plate's radius is outside the range of
 *          hrt_session_plate::radius_m or a target is over 10 m from the plate's centre; LIMIT_REACHED; WRONG_STATE
 *          during a reach or a set-up; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] for the scene and for the session. */
HRT_NODISCARD HRT_API hrt_result hrt_scene_register(hrt_scene scene, hrt_session session, uint64_t capacity,
                                                    hrt_target* out_targets) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "scene_init.h"

#endif
