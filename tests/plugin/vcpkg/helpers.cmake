# A double of vcpkg's functions, as far as the port uses them: cmake -P runs the portfile with it. It installs what BUILD has
# built instead of building, and is strict about what vcpkg is strict about.
#   cmake -D PORTFILE=... -D BUILD=... -D PACKAGES=... -P helpers.cmake
set(CURRENT_PACKAGES_DIR ${PACKAGES})

function(exists)
  foreach(path IN LISTS ARGN)
    if(NOT EXISTS "${path}")
      message(FATAL_ERROR "the port needs ${path}, which is not there")
    endif()
  endforeach()
endfunction()

function(vcpkg_check_linkage)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "ONLY_STATIC_LIBRARY;ONLY_DYNAMIC_LIBRARY;ONLY_DYNAMIC_CRT;ONLY_STATIC_CRT" "" "")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "vcpkg_check_linkage(${ARG_UNPARSED_ARGUMENTS})")
  endif()
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "SOURCE_PATH" "OPTIONS")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "vcpkg_cmake_configure(${ARG_UNPARSED_ARGUMENTS})")
  endif()
  exists(${ARG_SOURCE_PATH}/CMakeLists.txt)
  file(STRINGS ${ARG_SOURCE_PATH}/CMakeLists.txt declared REGEX "^option\\(")
  list(REMOVE_ITEM ARG_OPTIONS "-DHRT_PYTHON3=${PYTHON3}")  # no option: where the tool is
  foreach(option IN LISTS ARG_OPTIONS)
    string(REGEX REPLACE "^-D([A-Z_]+)=(ON|OFF)$" "\\1" name "${option}")
    if(NOT declared MATCHES "option\\(${name} ")
      message(FATAL_ERROR "the project has no option ${option}")
    endif()
  endforeach()
endfunction()

function(vcpkg_find_acquire_program name)
  if(NOT name STREQUAL "PYTHON3")
    message(FATAL_ERROR "vcpkg_find_acquire_program(${name})")
  endif()
  set(PYTHON3 python3 PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_install)
  foreach(component runtime development)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PACKAGES} --component ${component}
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endfunction()

function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "PACKAGE_NAME;CONFIG_PATH" "")
  exists(${PACKAGES}/${ARG_CONFIG_PATH}/${ARG_PACKAGE_NAME}Config.cmake)
  file(MAKE_DIRECTORY ${PACKAGES}/share)
  file(RENAME ${PACKAGES}/${ARG_CONFIG_PATH} ${PACKAGES}/share/${ARG_PACKAGE_NAME})
endfunction()

function(vcpkg_fixup_pkgconfig)
  exists(${PACKAGES}/lib/pkgconfig/haptic_retargeting.pc)
endfunction()

function(vcpkg_copy_pdbs)
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "COMMENT" "FILE_LIST")
  exists(${ARG_FILE_LIST})
  file(WRITE ${PACKAGES}/share/haptic-retargeting/copyright "")
  foreach(file IN LISTS ARG_FILE_LIST)
    file(READ ${file} text)
    file(APPEND ${PACKAGES}/share/haptic-retargeting/copyright "${text}")
  endforeach()
endfunction()

include(${PORTFILE})
