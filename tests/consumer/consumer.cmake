# Installs the components, then configures, builds and runs one program that sees only what was installed.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed)
  if(failed)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${NAME}: failed (${failed}): ${command}")
  endif()
endfunction()

string(REPLACE "," ";" components "${COMPONENTS}")
string(REPLACE "," ";" arguments "${ARGUMENTS}")
set(prefix ${FOLDER}/prefix)
file(REMOVE_RECURSE ${FOLDER})
foreach(component IN LISTS components)
  run(${CMAKE_COMMAND} --install ${PACKAGE_BUILD} --config ${BUILD_TYPE} --component ${component} --prefix ${prefix})
endforeach()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER}/build -G ${GENERATOR}
  -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${prefix}
  -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
file(STRINGS ${FOLDER}/build/CMakeCache.txt found REGEX "^slope_DIR:")
string(FIND "${found}" "${prefix}/" inside)
if(inside EQUAL -1)
  message(FATAL_ERROR "${NAME}: built against another slope: ${found}")
endif()
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${FOLDER}/build/${NAME} ${arguments})
