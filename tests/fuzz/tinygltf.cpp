// tinygltf itself, so that it is watched like what calls it: Debian's library is not.
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
