# Seconds that a person waits: a clean build, a second start of ./course, figures, the site.
include(${CMAKE_CURRENT_LIST_DIR}/../steps.cmake)

set(build ${source}/build/door)
set(figures ${logs}/figures)
file(REMOVE_RECURSE ${build} ${figures})
step("configure" COMMAND cmake --preset default -B ${build})
step("build" COMMAND cmake --build ${build})
step("first start" COMMAND ${source}/course --help)
step("second start" COMMAND ${source}/course --help)
step("figures: draft" COMMAND ${build}/bin/course figures --quality draft --out ${figures})
step("figures: lecture" COMMAND ${build}/bin/course figures --quality lecture --out ${figures})
step("docs" COMMAND ${build}/bin/course docs)
end_steps()
