# A toolchain: the newest Clang that is here. A preset can name only one compiler, and systems ship different ones.
include(${CMAKE_CURRENT_LIST_DIR}/find_program_of.cmake)
find_program_of("Clang" CMAKE_CXX_COMPILER)
