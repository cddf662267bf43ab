# What `cmake --install` puts in place of libairlight: the shared library (component Library); header, archive, CMake
# package and pkg-config file (component Development); and the Python package (component Python).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(library_folder ${CMAKE_INSTALL_LIBDIR})
set(include_folder ${CMAKE_INSTALL_INCLUDEDIR})
set(package_folder ${library_folder}/cmake/airlight)
set(made ${PROJECT_BINARY_DIR}/library)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/airlightConfig.cmake.in ${made}/airlightConfig.cmake
                              INSTALL_DESTINATION ${package_folder}
                              PATH_VARS library_folder include_folder)
# While the major version is 0, another minor version may have another header.
write_basic_package_version_file(${made}/airlightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${library_folder}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/airlight.pc.in ${made}/airlight.pc @ONLY)

install(TARGETS airlight_shared LIBRARY DESTINATION ${library_folder} COMPONENT Library
                                        NAMELINK_COMPONENT Development)
install(FILES ${PROJECT_BINARY_DIR}/libairlight.a DESTINATION ${library_folder} COMPONENT Development)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/include/airlight/airlight.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/airlight
        COMPONENT Development)
install(FILES ${made}/airlightConfig.cmake ${made}/airlightConfigVersion.cmake DESTINATION ${package_folder}
        COMPONENT Development)
install(FILES ${made}/airlight.pc DESTINATION ${library_folder}/pkgconfig COMPONENT Development)

if(TARGET airlight_python)
  # Debian's folder for packages of all versions of Python 3.
  set(python_destination lib/python3/dist-packages/airlight)
  install(TARGETS airlight_python LIBRARY DESTINATION ${python_destination} COMPONENT Python)
  install(FILES ${python_sources} DESTINATION ${python_destination} COMPONENT Python)
endif()
