# The first of some programs' names that is on the PATH, and nowhere else: the launcher and the chapters, which run
# gnuplot, look there.
function(find_on_path names result)
    separate_arguments(names UNIX_COMMAND "${names}")
    unset(path)
    find_program(path NAMES ${names} PATHS ENV PATH NO_DEFAULT_PATH NO_CACHE)
    set(${result} ${path} PARENT_SCOPE)
endfunction()

# find_program_of("Clang" result): the program of a package of packages.csv, the newest of its names that is here.
function(find_program_of package result)
    file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/packages.csv row REGEX "^${package},")
    string(REPLACE "," ";" row "${row}")
    list(GET row 2 names)
    find_on_path("${names}" path)
    if(NOT path)
        message(FATAL_ERROR "missing: ${package}; `course doctor` tells how to install it")
    endif()
    set(${result} ${path} PARENT_SCOPE)
endfunction()
