# Seconds that a person waits: a clean build, a second start of ./course, figures, the site.
#
# - `step`, `result`: what is waited for, and whether it went well. What it said lies in build/steps.
# - `seconds`: by the clock.
#
# It takes a quarter of an hour and more: all is built twice, and all figures are made twice.
include(${CMAKE_CURRENT_LIST_DIR}/../steps.cmake)

set(build ${source}/build/door)
set(figures ${logs}/figures)
file(REMOVE_RECURSE ${build} ${figures})
step("configure" COMMAND cmake --preset default -B ${build})
step("build: command and chapters" COMMAND cmake --build ${build} --target course_command chapters/all)
step("build: tests and benchmarks" COMMAND cmake --build ${build})
step("first start" COMMAND ${source}/course bench)
step("second start" COMMAND ${source}/course bench)
step("figures: draft" COMMAND ${build}/bin/course figures --quality draft --out ${figures})
step("figures: lecture" COMMAND ${build}/bin/course figures --quality lecture --out ${figures})
step("docs" COMMAND ${build}/bin/course docs)
end_steps()
