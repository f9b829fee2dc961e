# What we are built on, each found once; packages by name: cmake/install_packages.

# No version in the call: Eigen 5's package refuses a request for 3.4, with which it is compatible.
find_package(Eigen3 REQUIRED NO_MODULE)
if(Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen ${Eigen3_VERSION} is too old: 3.4 or later is needed")
endif()
find_package(nlohmann_json 3.10 REQUIRED)
find_package(Threads REQUIRED)
find_path(HRT_FAST_FLOAT_INCLUDE fast_float/fast_float.h REQUIRED)
find_path(HRT_TINYGLTF_INCLUDE tiny_gltf.h REQUIRED)
find_path(HRT_FMT_INCLUDE fmt/format.h REQUIRED)
if(HRT_BUILD_SAMPLES)
  find_package(CLI11 2.1 REQUIRED)
  find_package(OpenXR 1.0.20 REQUIRED)
endif()
if(HRT_BUILD_TESTS AND NOT CMAKE_CROSSCOMPILING)
  find_package(GTest REQUIRED)
endif()
