/* Preloaded into hello_xr -g OpenGL: Xvfb has no XFree86-VidMode extension, and what hello_xr then reads as
   the first video mode is never written. */
#include <stdlib.h>

// NOLINTBEGIN(readability-identifier-naming): the library's name
int XF86VidModeGetAllModeLines(void* display, int screen, int* count, void*** modes);

__attribute__((visibility("default"))) int XF86VidModeGetAllModeLines(void* display, int screen, int* count,
                                                                      void*** modes) {
  /* As the library does, the list and its modes, here one of zeros, are one block, which the caller frees. */
  void** all = (void**)calloc(1, sizeof *all + 256);
  (void)display;
  (void)screen;
  if (all == NULL) return 0;
  all[0] = (void*)(all + 1);
  *count = 1;
  *modes = all;
  return 1;
}
// NOLINTEND(readability-identifier-naming)
