# What the hosts take from the C headers: plugin/bindings/generate writes it beside their own files, where git ignores it.
# At configuring, and again after a change of the headers or of the generator; a file that stays the same is not touched.
# What is compiled into the library needs none of it, so only those who build a host, or the tests, need pycparser.
find_program(HRT_PYTHON3 python3 HINTS /usr/bin)
set(HRT_BINDINGS ${PROJECT_SOURCE_DIR}/plugin/bindings)
set(HRT_BINDINGS_MISSING "python3 is not there")
if(HRT_PYTHON3)
  execute_process(COMMAND ${HRT_PYTHON3} ${HRT_BINDINGS}/generate RESULT_VARIABLE failed ERROR_VARIABLE HRT_BINDINGS_MISSING)
  if(NOT failed)
    set(HRT_BINDINGS_MISSING "")
  endif()
  execute_process(COMMAND ${HRT_PYTHON3} ${HRT_BINDINGS}/unity/metas COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/plugin/include/haptic_retargeting/*.h ${HRT_BINDINGS}/generator/*.py)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources} ${HRT_BINDINGS}/generate
    ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/plugin/THIRD_PARTY_NOTICES.md)
endif()
if(HRT_BINDINGS_MISSING AND (HRT_BUILD_TESTS OR HRT_BUILD_HOSTS OR EMSCRIPTEN))
  message(FATAL_ERROR "The declarations of the hosts cannot be generated: ${HRT_BINDINGS_MISSING}")
endif()
