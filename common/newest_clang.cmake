# A toolchain: the newest Clang that is here. A preset can name only one compiler, and systems ship different ones.
find_program(newest_clang NAMES clang++-21 clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++)
if(NOT newest_clang)
    message(FATAL_ERROR "missing: Clang 16 or newer; `./course doctor` tells how to install it")
endif()
set(CMAKE_CXX_COMPILER ${newest_clang})
