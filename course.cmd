@echo off
rem The door to the course on Windows; see `course` for the others. It needs CMake, Ninja and LLVM (clang++) on the
rem PATH, gnuplot for pictures, and vcpkg, whose folder VCPKG_ROOT names: that installs what vcpkg.json lists.
setlocal
set root=%~dp0
set build=%root%build\default
if not defined VCPKG_ROOT (
    echo course: error: set VCPKG_ROOT to the folder of vcpkg, which installs the libraries 1>&2
    exit /b 2
)
if not exist "%build%\build.ninja" (
    pushd "%root%"
    cmake --preset default --fresh -DCMAKE_CXX_COMPILER=clang++ ^
        "-DCMAKE_TOOLCHAIN_FILE=%VCPKG_ROOT%\scripts\buildsystems\vcpkg.cmake" 1>&2 || (popd & exit /b 2)
    popd
)
cmake --build "%build%" --target course_command 1>&2 || exit /b 2
"%build%\bin\course.exe" %*
exit /b %ERRORLEVEL%
