// The one place where tinygltf is compiled.
#define TINYGLTF_IMPLEMENTATION
#include <fstream>  // its writer needs it

#include <tiny_gltf.h>
