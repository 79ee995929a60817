# What is installed of the laws. find_package(platen), or pkg-config, gives platen::law (headers) and platen::law_c (the
# compiled C interface); copying include/platen/law into a project does as well, the headers need nothing else.

# The C interface lives in src/capi and depends on platen::law alone, so that it is built with PLATEN_PROGRAM=OFF too.
# Static and position-independent, because DEM codes load it into plug-ins.
function(platen_add_c_interface)
  add_library(platen_law_c STATIC ${PROJECT_SOURCE_DIR}/src/capi/platen_law.cpp)
  add_library(platen::law_c ALIAS platen_law_c)
  target_link_libraries(platen_law_c PRIVATE platen::law $<BUILD_INTERFACE:platen_flags>
                        INTERFACE $<$<LINK_LANGUAGE:C>:stdc++> $<$<LINK_LANGUAGE:C>:m>) # a C program may not enable C++
  target_compile_options(platen_law_c PRIVATE -fno-math-errno) # roots of several numbers at once
  target_include_directories(platen_law_c PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                 $<INSTALL_INTERFACE:include>)
  set_target_properties(platen_law_c PROPERTIES EXPORT_NAME law_c OUTPUT_NAME platen_law
                                                POSITION_INDEPENDENT_CODE ON)
endfunction()

function(platen_install_laws)
  include(GNUInstallDirs)
  include(CMakePackageConfigHelpers)
  install(TARGETS platen_law platen_law_c EXPORT platen ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT law)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/platen DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT law)
  install(FILES ${PROJECT_SOURCE_DIR}/include/platen_law.h ${PROJECT_SOURCE_DIR}/include/platen_law.f90
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT law)

  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/platen)
  install(EXPORT platen NAMESPACE platen:: DESTINATION ${package} FILE platenTargets.cmake COMPONENT law)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/platenConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/platenConfig.cmake.in
                                ${PROJECT_BINARY_DIR}/platenConfig.cmake INSTALL_DESTINATION ${package})
  install(FILES ${PROJECT_BINARY_DIR}/platenConfig.cmake ${PROJECT_BINARY_DIR}/platenConfigVersion.cmake
          DESTINATION ${package} COMPONENT law)

  # Its folders are said from its own place, so that what is installed can be moved.
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig
             OUTPUT_VARIABLE up)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/platen.pc.in ${PROJECT_BINARY_DIR}/platen.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/platen.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT law)
endfunction()
