# Generates from plugin/bindings/api.json the library's tables of fields (in the build folder), and C headers and the
# declarations of each binding (in the source tree, ignored by git). Runs at configure time, and before a build if a file
# that is named below changed. Does not write unchanged files. Needs only Python's standard library.
find_program(HRT_PYTHON3 NAMES python3 python HINTS /usr/bin REQUIRED)
set(HRT_BINDINGS ${PROJECT_SOURCE_DIR}/plugin/bindings)
execute_process(COMMAND ${HRT_PYTHON3} ${HRT_BINDINGS}/generate ${PROJECT_BINARY_DIR}/generated COMMAND_ERROR_IS_FATAL ANY)
file(GLOB sources CONFIGURE_DEPENDS ${HRT_BINDINGS}/api.json ${HRT_BINDINGS}/generator/*.py)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources} ${HRT_BINDINGS}/generate
  ${HRT_BINDINGS}/godot/plate_node.h ${HRT_BINDINGS}/godot/README.md ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/plugin/THIRD_PARTY_NOTICES.md)
