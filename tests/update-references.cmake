# cmake -D PRODUCTS=folder -D REFERENCES=folder -D "CASES=names..." [-D BUILD=folder] [-D COMMIT=text] -P update-references.cmake
# with the reason in the environment variable WHY. Puts what the regression cases gave, <PRODUCTS>/<case>/products, in the
# place of the references, <REFERENCES>/<case>, and logs in NOTES.md there which ones changed, and why. Only what the
# case's tolerances.yaml names is a reference; what is none of the cases' is left alone. With BUILD, the cases are run
# first; without COMMIT, it is the one that is checked out.
set(why "$ENV{WHY}")
string(STRIP "${why}" why)
if(why STREQUAL "" OR why MATCHES "[|\n]")
  message(FATAL_ERROR "References change for a reason: give it in one line, without '|', as in\n"
    "  tests/update-references.sh \"the water level is drawn at 50 Pa\"")
endif()

if(BUILD)
  execute_process(
    COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${BUILD} -R "^regression\\..*\\.(clear|run|draw|tabulate)$" --output-on-failure
    COMMAND_ERROR_IS_FATAL ANY)
endif()

if(NOT COMMIT)
  execute_process(COMMAND git -C ${REFERENCES} rev-parse --short HEAD
    OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
endif()

# The names that tolerances.yaml has of files with these endings.
function(compared_files result tolerances)
  file(READ ${tolerances} text)
  string(REGEX REPLACE "#[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "[A-Za-z0-9_]+\\.(csv|png)" names "${text}")
  set(${result} ${names} PARENT_SCOPE)
endfunction()

# Nothing is touched unless everything is there.
set(changed FALSE)
foreach(case IN LISTS CASES)
  compared_files(names ${REFERENCES}/${case}/tolerances.yaml)
  foreach(name IN LISTS names)
    set(product ${PRODUCTS}/${case}/products/${name})
    if(NOT EXISTS ${product})
      message(FATAL_ERROR "${case} gives no ${name}, which its tolerances.yaml names")
    endif()
    execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${product} ${REFERENCES}/${case}/${name}
      RESULT_VARIABLE differs OUTPUT_QUIET ERROR_QUIET)
    if(differs)
      list(APPEND changed_${case} ${name})
      set(changed TRUE)
    endif()
  endforeach()
endforeach()

if(NOT changed)
  message(STATUS "every reference is as it was: nothing to log")
  return()
endif()
string(TIMESTAMP today "%Y-%m-%d" UTC)
foreach(case IN LISTS CASES)
  foreach(name IN LISTS changed_${case})
    file(COPY_FILE ${PRODUCTS}/${case}/products/${name} ${REFERENCES}/${case}/${name})
  endforeach()
  if(changed_${case})
    list(JOIN changed_${case} ", " names)
    file(APPEND ${REFERENCES}/NOTES.md "| ${today} | ${COMMIT} | `${case}/`: ${names} | ${why} |\n")
    message(STATUS "changed in ${case}: ${names}")
  endif()
endforeach()
