# Builds the checkout that this port is part of.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)
vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY)
vcpkg_find_acquire_program(PYTHON3)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DHRT_BUILD_TESTS=OFF -DHRT_BUILD_SAMPLES=OFF -DHRT_BUILD_HOSTS=OFF "-DHRT_PYTHON3=${PYTHON3}")
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME HapticRetargeting CONFIG_PATH lib/cmake/HapticRetargeting)
vcpkg_fixup_pkgconfig()
vcpkg_copy_pdbs()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/plugin/THIRD_PARTY_NOTICES.md")
