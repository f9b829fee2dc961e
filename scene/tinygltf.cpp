#include <fstream>  // tiny_gltf.h lacks it if TINYGLTF_NO_FS is defined

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
