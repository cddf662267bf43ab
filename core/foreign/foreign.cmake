# Other programs' pictures: EXRs by OpenEXR, all others through OpenImageIO by a module that is loaded when it is needed.
# Linking OpenImageIO would cost every start of the tool 0.2 CPU-s and 130 MB.
add_library(airlight_foreign STATIC ${CMAKE_CURRENT_LIST_DIR}/exr_picture.cpp
            ${CMAKE_CURRENT_LIST_DIR}/foreign_picture.cpp ${CMAKE_CURRENT_LIST_DIR}/module.cpp
            ${CMAKE_CURRENT_LIST_DIR}/jpeg_extent.cpp ${CMAKE_CURRENT_LIST_DIR}/png_extent.cpp
            ${CMAKE_CURRENT_LIST_DIR}/tiff_extent.cpp
            ${CMAKE_CURRENT_LIST_DIR}/vdb_head.cpp ${CMAKE_CURRENT_LIST_DIR}/voxels.cpp)
target_link_libraries(airlight_foreign PUBLIC airlight_flags PRIVATE airlight_output OpenEXR::OpenEXR PNG::PNG ${CMAKE_DL_LIBS})

add_library(airlight_foreign_module MODULE ${CMAKE_CURRENT_LIST_DIR}/module_foreign.cpp
            ${CMAKE_CURRENT_LIST_DIR}/module_voxels.cpp)
set_target_properties(airlight_foreign_module PROPERTIES
                      OUTPUT_NAME airlight_foreign PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}
                      CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
target_link_libraries(airlight_foreign_module PRIVATE airlight_flags OpenImageIO::OpenImageIO)
target_link_options(airlight_foreign_module PRIVATE LINKER:--as-needed)
airlight_harden(airlight_foreign_module)
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT AIRLIGHT_SANITIZE)
  target_compile_options(airlight_foreign_module PRIVATE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
endif()

# Building the tool also builds the module beside it.
cmake_language(DEFER CALL add_dependencies airlight airlight_foreign_module)
# Where the module lies once it is installed, and the way there from the program, which finds it wherever both are moved.
include(GNUInstallDirs)
set(AIRLIGHT_MODULE_FOLDER lib/airlight/modules)  # deeper than the folders for which CPack's package calls ldconfig
file(RELATIVE_PATH module_from_program /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${AIRLIGHT_MODULE_FOLDER})
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/module.cpp PROPERTIES
                            COMPILE_DEFINITIONS "AIRLIGHT_MODULE_FROM_PROGRAM=\"${module_from_program}\"")
