# Makes Debian's header-only libraries available to cross compilers, which must not use /usr/include, because it also
# contains the headers of this machine's C library.
get_property(in_try_compile GLOBAL PROPERTY IN_TRY_COMPILE)
if(in_try_compile)
  return()
endif()

set(root ${CMAKE_BINARY_DIR}/debian_headers)
file(MAKE_DIRECTORY ${root}/include ${root}/share/cmake ${root}/share/eigen3)
foreach(header CLI eigen3 fast_float fmt nlohmann tiny_gltf.h)
  file(CREATE_LINK /usr/include/${header} ${root}/include/${header} SYMBOLIC)
endforeach()
# The files are copied, because packages find their headers relative to them.
file(COPY /usr/share/cmake/CLI11 /usr/share/cmake/nlohmann_json DESTINATION ${root}/share/cmake)
file(COPY /usr/share/eigen3/cmake DESTINATION ${root}/share/eigen3)

list(APPEND CMAKE_FIND_ROOT_PATH ${root})
list(APPEND CMAKE_PREFIX_PATH ${root})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Debian's GoogleTest is for this machine; the tests build it for the target from its source.
set(HRT_GOOGLETEST_SOURCE /usr/src/googletest)
