# The installed CMake package: find_package(slope COMPONENTS solid seepage couple).
include(CMakePackageConfigHelpers)

set(slope_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/slope)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/slope-config.cmake.in
  ${PROJECT_BINARY_DIR}/slope-config.cmake INSTALL_DESTINATION ${slope_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/slope-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/slope-config.cmake ${PROJECT_BINARY_DIR}/slope-config-version.cmake
  ${PROJECT_SOURCE_DIR}/cmake/FindxxHash.cmake
  DESTINATION ${slope_package_dir} COMPONENT package)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT package)
