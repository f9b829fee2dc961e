# Installs and packages the shared libraries (component runtime), their headers, and the CMake package and pkg-config
# files (component development).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(HRT_LIBRARIES haptic_retargeting)
if(TARGET hrt_plate)
  list(APPEND HRT_LIBRARIES hrt_plate)
endif()
if(HRT_BUILD_STATIC)
  list(APPEND HRT_LIBRARIES haptic_retargeting_static)
endif()
install(TARGETS ${HRT_LIBRARIES} EXPORT HapticRetargetingTargets
  RUNTIME COMPONENT runtime
  LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development)
install(DIRECTORY plugin/include/haptic_retargeting TYPE INCLUDE COMPONENT development
        FILES_MATCHING PATTERN "*.h")
install(FILES plugin/bindings/api.json DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/haptic_retargeting COMPONENT development)

set(HRT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/HapticRetargeting)
install(EXPORT HapticRetargetingTargets NAMESPACE HapticRetargeting:: DESTINATION ${HRT_CMAKE_DIR}
        COMPONENT development)
configure_package_config_file(cmake/HapticRetargetingConfig.cmake.in HapticRetargetingConfig.cmake
  INSTALL_DESTINATION ${HRT_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(HapticRetargetingConfigVersion.cmake COMPATIBILITY ${HRT_COMPATIBILITY})
install(FILES
  ${PROJECT_BINARY_DIR}/HapticRetargetingConfig.cmake
  ${PROJECT_BINARY_DIR}/HapticRetargetingConfigVersion.cmake
  DESTINATION ${HRT_CMAKE_DIR} COMPONENT development)

# The prefix is relative to ${pcfiledir}, so that the file remains valid when the installation is moved.
file(RELATIVE_PATH HRT_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" HRT_PC_PREFIX "${HRT_PC_PREFIX}")
foreach(library ${HRT_LIBRARIES})
  set(HRT_PC_LIBRARY ${library})
  set(HRT_PC_DESCRIPTION "${PROJECT_DESCRIPTION}")
  if(library STREQUAL hrt_plate)
    set(HRT_PC_DESCRIPTION "Drives the plate of haptic retargeting by touch: serial lines, Dynamixel servos")
  endif()
  if(library STREQUAL haptic_retargeting_static)
    set(HRT_PC_CFLAGS " -DHRT_STATIC")
    set(HRT_PC_LIBS " -lstdc++ -lm -pthread")
  endif()
  configure_file(cmake/haptic_retargeting.pc.in ${library}.pc @ONLY)
  list(APPEND HRT_PC_FILES ${PROJECT_BINARY_DIR}/${library}.pc)
endforeach()
install(FILES ${HRT_PC_FILES}
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT runtime)
install(FILES plugin/THIRD_PARTY_NOTICES.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
install(FILES scene/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME scene.md COMPONENT development)
install(DIRECTORY samples/hello DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
foreach(page SETUP PROCESS README)  # README links to the others, and is therefore last
  hrt_install_readme(${CMAKE_CURRENT_SOURCE_DIR}/plugin/${page}.md ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
endforeach()

# Components tools and mock_runtime, for Debian's packages. The package for Windows contains hrt-plate.
set(component tools EXCLUDE_FROM_ALL)
if(WIN32)
  set(component runtime)
endif()
foreach(program IN ITEMS hrt-reach hrt-study hrt-plate)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME COMPONENT ${component})
  endif()
endforeach()
install(FILES samples/scenes/desk.gltf samples/scenes/table1.gltf DESTINATION ${CMAKE_INSTALL_DATADIR}/haptic-retargeting/scenes
        COMPONENT tools EXCLUDE_FROM_ALL)
if(HRT_BUILD_MOCK_RUNTIME)
  install(TARGETS hrtx_mock_runtime LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT mock_runtime EXCLUDE_FROM_ALL)
  install(FILES ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/hrtx_mock_runtime.json DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT mock_runtime EXCLUDE_FROM_ALL)
  install(PROGRAMS ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/hrtx-run TYPE BIN COMPONENT mock_runtime EXCLUDE_FROM_ALL)
  install(FILES samples/app/xr/openxr_hrtx_ridged_plate.h TYPE INCLUDE COMPONENT mock_runtime EXCLUDE_FROM_ALL)
  install(FILES ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/hrtx_script.schema.json
          DESTINATION ${CMAKE_INSTALL_DATADIR}/hrtx COMPONENT mock_runtime EXCLUDE_FROM_ALL)
endif()

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
set(CPACK_PACKAGE_NAME haptic-retargeting)
set(CPACK_PACKAGE_VENDOR "the haptic retargeting authors")
set(CPACK_PACKAGE_CONTACT "the haptic retargeting authors <haptic-retargeting@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
if(WIN32)
  set(CPACK_GENERATOR ZIP)
else()  # for any Linux; plugin/packaging makes Debian packages
  set(CPACK_GENERATOR TGZ)
endif()
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)  # one archive contains both components
include(CPack)
