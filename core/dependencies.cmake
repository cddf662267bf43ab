# Debian 12's libraries, with two packaging quirks worked around.
find_package(OpenEXR CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(PNG REQUIRED)
# The sun's position (liberfa-dev): a small C library without a CMake package.
find_path(ERFA_INCLUDE_DIR erfa.h REQUIRED)
find_library(ERFA_LIBRARY erfa REQUIRED)
# Time zones (libcctz-dev), also without a CMake package.
find_path(CCTZ_INCLUDE_DIR cctz/time_zone.h REQUIRED)
find_library(CCTZ_LIBRARY cctz REQUIRED)
find_package(OpenImageIO CONFIG REQUIRED)
# libopenimageio-dev's target names an OpenCV include directory that only libopencv-dev ships.
get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(oiio_existing)
foreach(directory IN LISTS oiio_includes)
  if(EXISTS "${directory}")
    list(APPEND oiio_existing "${directory}")
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${oiio_existing}")
# libopencolorio-dev installs its config where find_package does not look.
find_package(OpenColorIO CONFIG QUIET)
if(NOT OpenColorIO_FOUND)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(OCIO REQUIRED IMPORTED_TARGET OpenColorIO)
  add_library(OpenColorIO::OpenColorIO ALIAS PkgConfig::OCIO)
endif()
