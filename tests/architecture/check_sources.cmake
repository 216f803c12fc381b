# cmake -D ROOT=folder -P check_sources.cmake
# What each room may name. A line that starts a comment is not looked at.
set(violations "")
set(checked 0)

function(forbid files pattern why)
  file(GLOB_RECURSE paths RELATIVE ${ROOT} ${files})
  foreach(path IN LISTS paths)
    file(STRINGS ${ROOT}/${path} lines REGEX "${pattern}")
    foreach(line IN LISTS lines)
      if(NOT line MATCHES "^ *//")
        set(violations "${violations}\n  ${path}: ${line}  <- ${why}" PARENT_SCOPE)
        return()
      endif()
    endforeach()
  endforeach()
  list(LENGTH paths count)
  math(EXPR checked "${checked} + ${count}")
  set(checked ${checked} PARENT_SCOPE)
endfunction()

forbid("${ROOT}/libsolid/*.[ch]pp" "slope/(seepage|couple)/|(seepage|couple)::" "libsolid names another room")
forbid("${ROOT}/libseepage/*.[ch]pp" "slope/(solid|couple)/|(solid|couple)::" "libseepage names another room")
foreach(library IN ITEMS libsolid libseepage libcouple)
  forbid("${ROOT}/${library}/*.[ch]pp" "#include *[<\"](vtk|CLI/)" "VTK and CLI11 live in tools")
  forbid("${ROOT}/${library}/*.[ch]pp" "std::(cout|cerr|clog|print)|(^|[^a-z_])f?(printf|puts) *\\(|<iostream>|fmt::print"
    "libraries print nothing")
  forbid("${ROOT}/${library}/include/*.hpp" "#include *[<\"](fmt/|yaml-cpp/|tbb/)|YAML::|fmt::"
    "fmt, yaml-cpp and TBB stay out of public headers")
endforeach()
foreach(library IN ITEMS libsolid libseepage)
  forbid("${ROOT}/${library}/*.[ch]pp" "#include *[<\"](fmt/|yaml-cpp/)" "fmt and yaml-cpp are private to libcouple")
endforeach()
foreach(room IN ITEMS libsolid libseepage libcouple tools/common tools/slope-sim tools/slope-render)
  forbid("${ROOT}/${room}/*.[ch]pp" "#include *[<\"]openturns/" "OpenTURNS lives in tools/study")
endforeach()
# libcouple has three rooms: the case, text to values, knows of the run and the results nothing and of the solvers their
# parameters; the results, what was found to text and back, know of the run nothing.
set(upwards "#include *[<\"](results/|run/|\\.\\./|slope/couple/(checkpoint|results|simulation|state|summary|water_amounts)|slope/(solid|seepage)/([^s]|s[^o]))")
foreach(files IN ITEMS src/case/*.[ch]pp include/slope/couple/case.hpp include/slope/couple/csv_rows.hpp
    include/slope/couple/document.hpp include/slope/couple/geometry.hpp include/slope/couple/read_case.hpp
    include/slope/couple/text_file.hpp)
  forbid("${ROOT}/libcouple/${files}" "${upwards}" "the case names the run or a solver")
endforeach()
foreach(files IN ITEMS src/results/*.[ch]pp include/slope/couple/results.hpp include/slope/couple/summary.hpp
    include/slope/couple/water_amounts.hpp)
  forbid("${ROOT}/libcouple/${files}" "#include *[<\"](run/|\\.\\./|slope/couple/(checkpoint|simulation|state)|slope/(solid|seepage)/)"
    "the results name the run or a solver")
endforeach()

if(checked EQUAL 0)
  message(FATAL_ERROR "no source file found in ${ROOT}")
endif()
if(violations)
  message(FATAL_ERROR "lines in the wrong room:${violations}")
endif()
