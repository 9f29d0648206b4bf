# Is the code sound where no test looks? Clang, sanitizers, clang-tidy, and the same images from two compilers.
#
# - `step`, `result`: what is looked at, and whether it is sound. What it said lies in build/steps.
# - `seconds`: by the clock.
#
# It takes an hour and more: all is built four times and tested twice.
include(${CMAKE_CURRENT_LIST_DIR}/../steps.cmake)
include(${source}/common/find_program_of.cmake)

step("GCC: build" COMMAND cmake --preset default COMMAND cmake --build --preset default)
step("Clang: build" COMMAND cmake --preset clang COMMAND cmake --build --preset clang)

foreach(compiler default clang)
    file(REMOVE_RECURSE ${logs}/${compiler})
    step("${compiler}: draft of all figures"
        COMMAND ${source}/build/${compiler}/bin/course figures --quality draft --out ${logs}/${compiler})
endforeach()
step("images: GCC and Clang agree to the bit"
    COMMAND ${CMAKE_COMMAND} -DONE=${logs}/default -DOTHER=${logs}/clang -P ${source}/tests/same_images.cmake)

step("Clang: tests" COMMAND ctest --preset clang)
step("sanitizers: build" COMMAND cmake --preset checked COMMAND cmake --build --preset checked)
step("sanitizers: tests" COMMAND ctest --preset checked)

# clang-tidy looks at each file as it is compiled, on all cores; the code itself need not be fast here
find_program_of("clang-tidy" tidy)
step("clang-tidy"
    COMMAND cmake --preset clang -B ${source}/build/tidy -DCMAKE_BUILD_TYPE=Debug -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_CXX_CLANG_TIDY=${tidy}
    COMMAND cmake --build ${source}/build/tidy -- -k 0)
end_steps()
