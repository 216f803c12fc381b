# How the project's libraries, programs and tests are compiled.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# What a program needs to be compiled and linked with a library of this build: Eigen's alignment depends on the
# instruction set, and the sanitizers on the whole program, so these travel with the installed libraries.
set(slope_abi_options $<$<BOOL:${SLOPE_NATIVE}>:-march=native>)
set(slope_sanitizers $<$<BOOL:${SLOPE_SANITIZE}>:-fsanitize=address,undefined>)

# GCC 12 warns of overlapping copies in its own std::string (GCC bug 105651) and, with -march=native, of values that are
# undefined on purpose in its own AVX-512 header (GCC bug 105593).
set(slope_false_alarms "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND slope_false_alarms -Wno-restrict $<$<BOOL:${SLOPE_NATIVE}>:-Wno-maybe-uninitialized>)
endif()

add_library(slope_compile_options INTERFACE)
target_compile_options(slope_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  $<$<BOOL:${SLOPE_WERROR}>:-Werror>
  ${slope_false_alarms}
  ${slope_abi_options} ${slope_sanitizers}
  $<$<BOOL:${SLOPE_SANITIZE}>:-fno-sanitize-recover=all> $<$<BOOL:${SLOPE_SANITIZE}>:-fno-omit-frame-pointer>)
target_link_options(slope_compile_options INTERFACE ${slope_sanitizers})
target_compile_definitions(slope_compile_options INTERFACE $<$<CONFIG:Debug>:EIGEN_INITIALIZE_MATRICES_BY_NAN>)

# slope_library(NAME name DEPENDS targets... PRIVATE_DEPENDS targets...): one of the project's libraries, slope::name.
# Its public headers are a file set, so that a header is visible to another library only through
# target_link_libraries, and each is compiled on its own (target all_verify_interface_header_sets).
function(slope_library)
  cmake_parse_arguments(ARG "" "NAME" "DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target slope_${ARG_NAME})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS include/*.hpp)
  add_library(${target} ${sources})
  add_library(slope::${ARG_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${ARG_NAME}
    LINKER_LANGUAGE CXX
    POSITION_INDEPENDENT_CODE ON
    VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} INTERFACE ${slope_abi_options} ${slope_sanitizers})
  target_link_options(${target} INTERFACE ${slope_sanitizers})
  target_link_libraries(${target}
    PUBLIC ${ARG_DEPENDS}
    PRIVATE ${ARG_PRIVATE_DEPENDS} $<BUILD_INTERFACE:slope_compile_options>)
  if(SLOPE_INSTALL)
    install(TARGETS ${target} EXPORT slope-${ARG_NAME}
      ARCHIVE COMPONENT ${ARG_NAME}
      LIBRARY COMPONENT ${ARG_NAME}
      RUNTIME COMPONENT ${ARG_NAME}
      FILE_SET HEADERS COMPONENT ${ARG_NAME})
    install(EXPORT slope-${ARG_NAME} NAMESPACE slope:: COMPONENT ${ARG_NAME}
      DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/slope)
  endif()
endfunction()
