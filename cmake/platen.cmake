# How a folder of the house becomes a target.

add_library(platen_flags INTERFACE)
target_compile_options(platen_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                                                $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow
                                                -Wno-array-bounds -Wno-maybe-uninitialized>) # false alarms of GCC 12 on std::string
# Without any optimisation fmt's headers switch -Og on for themselves, and what GCC then takes Eigen's prefetches for is refused.
target_compile_options(platen_flags INTERFACE $<$<CONFIG:Debug>:-Og>)
if(PLATEN_WARNINGS_AS_ERRORS)
  target_compile_options(platen_flags INTERFACE -Werror)
endif()
if(PLATEN_SANITIZE) # of GCC without checks of each pointer for 0, which a fault shows too, and for alignment: half the time to compile
  target_compile_options(platen_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-fno-sanitize=null,alignment>)
  target_link_options(platen_flags INTERFACE -fsanitize=address,undefined)
endif()
if(PLATEN_FUZZ)
  target_compile_options(platen_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# platen_traps(PROGRAM): floating-point faults end it where they happen. Not for materials, whose returns try states that are
# none and refuse them, nor for laws: their kernels compute lanes that they do not use, and divide by zero there.
function(platen_traps program)
  if(PLATEN_TRAPS)
    target_sources(${program} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/traps.cpp)
  endif()
endfunction()

# The program and the Python package are linked from the same objects.
set(platen_objects -fPIC -fvisibility=hidden)

# platen_precompiled(NAME LIBRARY HEADERS...): headers compiled once, for other targets to REUSE_FROM. This saves time and
# nothing else: every file still includes what it uses, and compiles with CMAKE_DISABLE_PRECOMPILE_HEADERS=ON. They have a
# target of their own, because GCC refuses them (-Winvalid-pch) where a macro that they were compiled with is missing.
function(platen_precompiled name library)
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${library} platen_flags)
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# platen_folder(FOLDER [folders and libraries it stands on...]): src/FOLDER/*.cpp as target platen::FOLDER, of a/b as platen::a_b.
function(platen_folder folder)
  string(REPLACE "/" "_" name ${folder})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp)
  add_library(platen_${name} STATIC ${sources})
  add_library(platen::${name} ALIAS platen_${name})
  target_include_directories(platen_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(platen_${name} PUBLIC ${ARGN} PRIVATE platen_flags)
  target_compile_options(platen_${name} PRIVATE ${platen_objects})
  target_precompile_headers(platen_${name} REUSE_FROM platen_headers)
endfunction()

# platen_tests(TIER FOLDER [libraries...]): tests/TIER/FOLDER/*_test.cpp as one program; files that end in
# _slow_test.cpp become a second program whose tests carry the ctest label "slow".
function(platen_tests tier folder)
  file(GLOB quick CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${tier}/${folder}/*_test.cpp)
  set(slow ${quick})
  list(FILTER quick EXCLUDE REGEX "_slow_test\\.cpp$")
  list(FILTER slow INCLUDE REGEX "_slow_test\\.cpp$")
  foreach(kind quick slow)
    if(${kind})
      set(program ${tier}_${folder})
      if(kind STREQUAL "slow")
        string(APPEND program _slow)
      endif()
      add_executable(${program} ${${kind}})
      target_link_libraries(${program} PRIVATE ${ARGN} GTest::gtest_main platen_flags)
      if(folder MATCHES "^(core|fe)$")
        platen_traps(${program})
      endif()
      target_precompile_headers(${program} REUSE_FROM platen_test_headers)
      target_compile_definitions(${program} PRIVATE PLATEN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
      if(tier STREQUAL "unit" AND kind STREQUAL "quick")
        add_dependencies(unit_tests ${program})
      endif()
      set(labels ${tier})
      if(kind STREQUAL "slow")
        set(labels slow)
      endif()
      gtest_discover_tests(${program} DISCOVERY_TIMEOUT 60 TEST_PREFIX ${tier}.${folder}.
                           PROPERTIES LABELS "${labels}" TIMEOUT 1800)
    endif()
  endforeach()
endfunction()
