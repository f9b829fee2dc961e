# hrt_add_library and hrt_add_executable are add_library and add_executable with the compiler flags of this file.

add_library(hrt_flags INTERFACE)
target_compile_features(hrt_flags INTERFACE cxx_std_20)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(hrt_flags INTERFACE
    # Compilers fuse different multiplications and additions, and a fused one rounds once: results would differ.
    -ffp-contract=off
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
    # Allowed: designated initialisers that omit fields with defaults, and array indices of type int.
    -Wno-missing-field-initializers -Wno-sign-conversion
    # gcc 12 wrongly reports an overlap in "text" + std::string.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    # In a unity build, names of another source would be reported as shadowed, and gcc 12 wrongly reports reads of an
    # empty std::optional in inlined functions that check it.
    $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-shadow>
    $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND HRT_SANITIZE STREQUAL "thread")
  # gcc 12 wrongly reports a use after free in Eigen's matrices.
  target_compile_options(hrt_flags INTERFACE -Wno-use-after-free)
endif()
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT HRT_SANITIZE)  # sanitizers detect the same errors
  target_compile_options(hrt_flags INTERFACE -fstack-protector-strong
    $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE>
    $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=$<IF:$<BOOL:$<TARGET_PROPERTY:HRT_HARDENED>>,3,2>>)
  include(CheckCXXCompilerFlag)
  foreach(flag -fcf-protection -fstack-clash-protection)
    check_cxx_compiler_flag(${flag} HRT_HAS${flag})
    if(HRT_HAS${flag})
      target_compile_options(hrt_flags INTERFACE $<$<BOOL:$<TARGET_PROPERTY:HRT_HARDENED>>:${flag}>)
    endif()
  endforeach()
  target_link_options(hrt_flags INTERFACE LINKER:-z,relro,-z,now,-z,noexecstack)
endif()
if(WIN32 AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(hrt_flags INTERFACE -fstack-protector-strong)
  target_link_options(hrt_flags INTERFACE -fstack-protector-strong)  # links libssp statically
endif()
target_compile_definitions(hrt_flags INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
# Build type for the sanitizers: fast enough to run all tests, with functions and lines in reports. It takes half the
# compile time of a release with debug information.
set(CMAKE_C_FLAGS_SANITIZE "-O1 -g1")
set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1")
if(HRT_SANITIZE)
  target_compile_options(hrt_flags INTERFACE -fsanitize=${HRT_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  target_link_options(hrt_flags INTERFACE -fsanitize=${HRT_SANITIZE})
endif()

function(hrt_add_library name)
  add_library(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:hrt_flags>)
endfunction()

function(hrt_add_executable name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:hrt_flags>)
  if(HRT_SANITIZE)  # programs in C load libraries that need the C++ part of clang's sanitizers
    set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  endif()
  if(EMSCRIPTEN)
    # With these options, programs run in node, access files and return an exit code. -O1 only concerns the loader.
    target_link_options(${name} PRIVATE -O1 -sNODERAWFS=1 -sEXIT_RUNTIME=1 -sWASM_ASYNC_COMPILATION=0
                        -sALLOW_MEMORY_GROWTH=1)
  endif()
endfunction()

# hrt_harden(name): enables the compiler's run-time checks (HRT_HARDENED above) for a target that parses untrusted
# arguments, files or serial data.
function(hrt_harden name)
  set_target_properties(${name} PROPERTIES HRT_HARDENED ON)
endfunction()

# hrt_precompile(name HEADERS...): precompiles headers for a target with many C++ sources, whose compile time is mostly
# that of these headers. The options let ccache store the objects. Unity builds are faster without precompiled headers.
function(hrt_precompile name)
  get_target_property(as_one ${name} UNITY_BUILD)
  if(NOT as_one)
    target_precompile_headers(${name} PRIVATE ${ARGN})
    target_compile_options(${name} PRIVATE
      $<IF:$<CXX_COMPILER_ID:GNU>,-fpch-preprocess,SHELL:-Xclang -fno-pch-timestamp>)
  endif()
endfunction()

# hrt_fuzzed(name): adds the counters of libFuzzer to a target, if fuzz targets are built.
function(hrt_fuzzed name)
  if(HRT_FUZZ)
    target_compile_options(${name} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# Before version 1.0, a minor version may change the interface; after that, only a major version may.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(HRT_ABI_VERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(HRT_COMPATIBILITY SameMinorVersion)
else()
  set(HRT_ABI_VERSION ${PROJECT_VERSION_MAJOR})
  set(HRT_COMPATIBILITY SameMajorVersion)
endif()

# hrt_make_loadable(name MAP): configures a shared library that any process can load. It exports only the names in MAP, or
# on Windows those that the sources export, and contains the C++ runtime. On Windows, import libraries for MinGW (.dll.a)
# and MSVC (.lib) and a .def file for other compilers are written to the folder of the DLL.
function(hrt_make_loadable name map)
  set_target_properties(${name} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${HRT_ABI_VERSION})
  if(WIN32)
    set_target_properties(${name} PROPERTIES PREFIX "" ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
    set(beside ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name})
    target_link_options(${name} PRIVATE LINKER:--output-def=${beside}.def
      LINKER:--gc-sections $<$<CONFIG:Release>:LINKER:--strip-all>)
    find_program(HRT_LLVM_DLLTOOL llvm-dlltool)
    if(NOT HRT_LLVM_DLLTOOL)
      message(FATAL_ERROR "llvm-dlltool is missing: cmake/install_packages mingw64 installs it")
    endif()
    add_custom_command(TARGET ${name} POST_BUILD BYPRODUCTS ${beside}.lib
      COMMAND sed -i "1i LIBRARY ${name}.dll" ${beside}.def
      COMMAND ${HRT_LLVM_DLLTOOL} -m i386:x86-64 -d ${beside}.def -l ${beside}.lib VERBATIM)
    install(FILES ${beside}.def ${beside}.lib TYPE LIB COMPONENT development)
  elseif(ANDROID)
    target_link_options(${name} PRIVATE LINKER:--gc-sections LINKER:-z,max-page-size=16384
      LINKER:--version-script=${map})
  elseif(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    # Without this option, thread-local variables of a library that was loaded by dlopen() are allocated at their first
    # use in a thread, which may be a real-time call.
    target_compile_options(${name} PRIVATE -ftls-model=initial-exec)
    target_link_options(${name} PRIVATE LINKER:--version-script=${map})
    set_target_properties(${name} PROPERTIES LINK_DEPENDS ${map})
    hrt_bring_runtime(${name})
  endif()
endfunction()

# hrt_bring_runtime(name): links the C++ runtime statically on Linux, because the host may have another one.
function(hrt_bring_runtime name)
  target_link_options(${name} PRIVATE -static-libstdc++ LINKER:--gc-sections $<$<CONFIG:Release>:LINKER:--strip-all>)
  if(NOT HRT_SANITIZE)  # the functions of sanitizers are defined in the program
    target_link_options(${name} PRIVATE -static-libgcc LINKER:-z,defs)
  endif()
endfunction()

# hrt_install_readme(README FOLDER [PICTURES folder/] options of install()...): installs a page that
# packaged_readme.cmake has converted.
function(hrt_install_readme readme folder)
  cmake_parse_arguments(ARG "" PICTURES "" ${ARGN})
  install(CODE "
    set(README \"${readme}\")
    set(FOLDER \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${folder}\")
    set(PICTURES \"${ARG_PICTURES}\")
    include(\"${PROJECT_SOURCE_DIR}/cmake/packaged_readme.cmake\")" ${ARG_UNPARSED_ARGUMENTS})
endfunction()
