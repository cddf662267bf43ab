# Destinations of `cmake --install` and CPack. All files exist once the target `airlight` is built.
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME Tool)
find_program(GZIP gzip REQUIRED)

set(documents ${PROJECT_BINARY_DIR}/documents)

# The program itself makes these files as soon as it is linked.
set(made_by_program ${documents}/airlight.1.gz ${documents}/airlight.bash ${documents}/_airlight
                    ${documents}/airlight.fish)
add_custom_command(
  TARGET airlight POST_BUILD
  COMMAND ${CMAKE_COMMAND} -DAIRLIGHT=$<TARGET_FILE:airlight> -DOUT=${documents} -DGZIP=${GZIP}
          -P ${PROJECT_SOURCE_DIR}/app/program_documents.cmake
  BYPRODUCTS ${made_by_program}
  VERBATIM)

set(changelog ${documents}/changelog.gz)
set(copyright ${documents}/copyright)
# The pages and the pictures in them, in the folders of the source, so that their links lead to one another.
file(GLOB pages CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/app/*.md
     ${PROJECT_SOURCE_DIR}/core/*.md ${PROJECT_SOURCE_DIR}/presets/*.md ${PROJECT_SOURCE_DIR}/presets/gallery/chart-*.png
     ${PROJECT_SOURCE_DIR}/presets/gallery/day.png ${PROJECT_SOURCE_DIR}/presets/gallery/night.png
     ${PROJECT_SOURCE_DIR}/presets/gallery/polarisation.png
     ${PROJECT_SOURCE_DIR}/presets/gallery/setting-sun.png ${PROJECT_SOURCE_DIR}/tests/truth/*.md)
# Packages whose code is part of the program: headers and static libraries.
set(included libcli11-dev nlohmann-json3-dev libeigen3-dev nettle-dev liberfa-dev libnova-dev libvulkan-volk-dev
    libvulkan-dev spirv-headers spirv-tools)
set(sources ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/LICENSE
            ${PROJECT_SOURCE_DIR}/app/project_documents.cmake)
add_custom_command(
  OUTPUT ${changelog} ${copyright}
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUT=${documents} -DGZIP=${GZIP} "-DINCLUDED=${included}"
          -DVERSION=${PROJECT_VERSION} "-DMAINTAINER=${AIRLIGHT_MAINTAINER}"
          -P ${PROJECT_SOURCE_DIR}/app/project_documents.cmake
  DEPENDS ${sources}
  VERBATIM)
add_custom_target(airlight_documents DEPENDS ${changelog} ${copyright})
add_dependencies(airlight airlight_documents)

# All or nothing: before the first file is copied, all files are checked to exist and all folders to be writable. The
# folders are then made, readable by all whatever the umask is.
set(manual_folder ${CMAKE_INSTALL_MANDIR}/man1)
set(shared_folder ${CMAKE_INSTALL_DATADIR}/airlight)
set(about_folder ${CMAKE_INSTALL_DATADIR}/doc/airlight)
set(bash_folder ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
set(fish_folder ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
set(installed_files $<TARGET_FILE:airlight> $<TARGET_FILE:airlight_foreign_module> ${made_by_program} ${changelog}
                    ${copyright})
set(installed_folders ${CMAKE_INSTALL_BINDIR} ${AIRLIGHT_MODULE_FOLDER} ${manual_folder} ${shared_folder}/presets
                      ${about_folder} ${bash_folder} ${fish_folder})
set(more_packages Formats:airlight-formats)  # beside the tool's, by component
if(TARGET airlight_libraries)
  # What core/library/install.cmake puts in place after the check.
  add_dependencies(airlight airlight_libraries)
  list(APPEND installed_files $<TARGET_FILE:airlight_shared> ${PROJECT_BINARY_DIR}/libairlight.a)
  list(APPEND installed_folders ${CMAKE_INSTALL_LIBDIR}/cmake/airlight ${CMAKE_INSTALL_LIBDIR}/pkgconfig
                                ${CMAKE_INSTALL_INCLUDEDIR}/airlight)
  set(shared_package libairlight${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  list(APPEND more_packages Library:${shared_package} Development:libairlight-dev)
  if(TARGET airlight_python)
    list(APPEND installed_files $<TARGET_FILE:airlight_python>)
    list(APPEND installed_folders lib/python3/dist-packages/airlight)
    list(APPEND more_packages Python:python3-airlight)
  endif()
endif()
foreach(pair IN LISTS more_packages)
  string(REGEX REPLACE ".*:" "" package ${pair})
  list(APPEND installed_folders ${CMAKE_INSTALL_DATADIR}/doc/${package})
endforeach()
foreach(page IN LISTS pages)
  get_filename_component(folder ${page} DIRECTORY)
  list(APPEND installed_folders ${about_folder}/${folder})
endforeach()
list(REMOVE_DUPLICATES installed_folders)
install(CODE "set(airlight_files \"${installed_files}\")
  set(airlight_build \"${PROJECT_BINARY_DIR}\")
  # The folder that zsh searches; Debian's packages have one of their own.
  set(airlight_zsh \"site-functions\")
  if(CMAKE_INSTALL_PREFIX MATCHES \"/usr/?$\")
    set(airlight_zsh \"vendor-completions\")
  endif()
  set(airlight_folders \"${installed_folders};${CMAKE_INSTALL_DATADIR}/zsh/\${airlight_zsh}\")")
install(SCRIPT ${PROJECT_SOURCE_DIR}/app/check_install.cmake)

install(TARGETS airlight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS airlight_foreign_module LIBRARY DESTINATION ${AIRLIGHT_MODULE_FOLDER} COMPONENT Formats)
install(FILES ${documents}/airlight.1.gz DESTINATION ${manual_folder})
install(FILES ${documents}/airlight.bash DESTINATION ${bash_folder} RENAME airlight)
install(FILES ${documents}/airlight.fish DESTINATION ${fish_folder})
install(FILES ${documents}/_airlight DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/\${airlight_zsh}")
install(FILES ${airlight_preset_files} DESTINATION ${shared_folder}/presets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/presets/schema ${PROJECT_SOURCE_DIR}/presets/plates
        DESTINATION ${shared_folder}/presets)
install(FILES ${changelog} ${copyright} DESTINATION ${about_folder})
foreach(page IN LISTS pages)
  get_filename_component(folder ${page} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${about_folder}/${folder})
endforeach()

# The Debian packages; scripts/package makes them.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL Tool)
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME airlight)
set(CPACK_PACKAGE_NAME airlight)
# Names the release whose libraries the package needs, as Debian's backports do: 0.1.0~deb12 is older than 0.1.0~deb13,
# so that an upgrade of the release brings the other package, and both are older than a package of Debian's own.
cmake_host_system_information(RESULT release QUERY DISTRIB_INFO)
string(REGEX REPLACE "^debian" "deb" release "${release_ID}${release_VERSION_ID}")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION}~${release})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "headless sky renderer with measured accuracy")
set(CPACK_PACKAGE_DESCRIPTION
    "Renders skies of Earth-like and other atmospheres from JSON presets by Vulkan\n\
compute, on a GPU or on Mesa's software device, to scene-linear OpenEXR and to\n\
PNG. Compares renders with references for continuous integration.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${AIRLIGHT_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries and files opened at run time by name, unknown to the linker: the Vulkan loader, a driver, the zones' files.
set(vulkan "libvulkan1, mesa-vulkan-drivers | vulkan-icd")
set(CPACK_DEBIAN_TOOL_PACKAGE_DEPENDS "${vulkan}, tzdata")
set(CPACK_DEBIAN_TOOL_PACKAGE_SUGGESTS "ffmpeg, gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_TOOL_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")

# The module for pictures that are no EXRs: OpenImageIO brings four fifths of the packages that all of this needs.
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "airlight-formats (= ${CPACK_PACKAGE_VERSION})")
set(CPACK_DEBIAN_FORMATS_PACKAGE_DEPENDS "airlight (= ${CPACK_PACKAGE_VERSION})")
set(CPACK_DEBIAN_FORMATS_DESCRIPTION
    "headless sky renderer, formats of pictures\n Lets airlight read plates and maps in PNG, TIFF, JPEG, Radiance HDR and others,\n and clouds of OpenVDB.")

# Further packages. Each has the licences of the code that it holds.
foreach(pair IN LISTS more_packages)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  install(FILES ${copyright} ${changelog} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
# What other packages that link it depend on, and that the linker's cache is made anew.
set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
file(WRITE ${PROJECT_BINARY_DIR}/debian/shlibs "libairlight ${abi} libairlight${abi} (>= ${PROJECT_VERSION}~)\n")
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "${vulkan}, tzdata")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "physically based skies in memory\n Renders skies of presets to arrays of radiance.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${shared_package} (= ${CPACK_PACKAGE_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "nettle-dev, liberfa-dev, libnova-dev, libcctz-dev, spirv-tools")  # to link the archive
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "physically based skies in memory, to build with\n Header, archive, CMake package and pkg-config file of libairlight.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
# What Python compiles there when root imports it is of no package.
file(WRITE ${PROJECT_BINARY_DIR}/debian/prerm
     "#!/bin/sh\nset -e\nrm -rf /usr/lib/python3/dist-packages/airlight/__pycache__\n")
file(CHMOD ${PROJECT_BINARY_DIR}/debian/prerm PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                          WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/prerm)
math(EXPR next_python "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "${vulkan}, tzdata, python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next_python}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "physically based skies as NumPy arrays\n Renders skies of presets from Python.")
include(CPack)
