# Android on 64-bit ARM by Google's NDK in ANDROID_NDK_HOME. This file was never used, because no NDK or device was available.
if(NOT EXISTS "$ENV{ANDROID_NDK_HOME}/build/cmake/android.toolchain.cmake")
  message(FATAL_ERROR "ANDROID_NDK_HOME is \"$ENV{ANDROID_NDK_HOME}\"; it must name the folder of an NDK, r23 or later")
endif()
set(ANDROID_ABI arm64-v8a)
set(ANDROID_PLATFORM android-29)
set(ANDROID_STL c++_static)
include($ENV{ANDROID_NDK_HOME}/build/cmake/android.toolchain.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/debian_headers.cmake)
