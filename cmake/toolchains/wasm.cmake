# WebAssembly by Debian's emscripten; programs are run by node.
set(CMAKE_CROSSCOMPILING_EMULATOR node)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
# WebAssembly's own exceptions: those of JavaScript would need functions of its loader at every turn.
set(CMAKE_C_FLAGS_INIT -fwasm-exceptions)
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/wasm_libcxx.h")
include(${CMAKE_CURRENT_LIST_DIR}/debian_headers.cmake)
