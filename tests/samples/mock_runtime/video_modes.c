/* Preloaded into hello_xr -g OpenGL: Xvfb has no XFree86-VidMode extension, and what hello_xr then reads as
   the first video mode nobody has written. */
int XF86VidModeGetAllModeLines(void* display, int screen, int* count, void*** modes);

__attribute__((visibility("default"))) int XF86VidModeGetAllModeLines(void* display, int screen, int* count,
                                                                      void*** modes) {
  static unsigned char mode[256]; /* an XF86VidModeModeInfo of zeros, and room behind it */
  static void* all[] = {mode};
  (void)display;
  (void)screen;
  *count = 1;
  *modes = all;
  return 1;
}
