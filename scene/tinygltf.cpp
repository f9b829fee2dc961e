// tinygltf's own code, compiled here and nowhere else: without the image decoders and without file access
// (CMakeLists.txt sets the macros), and so without Debian's shared library of it.
#include <fstream>  // which the header forgets without file access

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
