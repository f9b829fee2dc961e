# WebAssembly by Debian's emscripten; node runs programs.
set(CMAKE_CROSSCOMPILING_EMULATOR node)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
# Exceptions of WebAssembly. Exceptions in JavaScript would add a function to the loader for each call that may throw.
set(CMAKE_C_FLAGS_INIT -fwasm-exceptions)
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/wasm_libcxx.h")
include(${CMAKE_CURRENT_LIST_DIR}/debian_headers.cmake)
