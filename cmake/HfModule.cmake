# hf_add_module(<name> SOURCES ... HEADERS ... [PUBLIC ...] [PRIVATE ...])
#   Defines hybridfusion_<name> (alias hybridfusion::<name>) with its own include root, so that a module can only
#   include the headers of modules it links. hf_add_tests(<name> SOURCES ... [LIBRARIES ...])
#   adds one gtest program per module.
add_library(hf_build_flags INTERFACE)
target_compile_features(hf_build_flags INTERFACE cxx_std_23)
target_compile_options(hf_build_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wnull-dereference $<$<BOOL:${HF_WERROR}>:-Werror>)
if(HF_SANITIZE)
  target_compile_options(hf_build_flags INTERFACE -fsanitize=${HF_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(hf_build_flags INTERFACE -fsanitize=${HF_SANITIZE})
endif()

function(hf_add_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  set(target hybridfusion_${name})
  add_library(${target} ${ARG_SOURCES})
  add_library(hybridfusion::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${ARG_HEADERS})
  # Third-party headers are SYSTEM: their warnings are not ours.
  set_target_properties(${target} PROPERTIES NO_SYSTEM_FROM_IMPORTED OFF)
  target_include_directories(${target} PRIVATE src)
  target_compile_features(${target} PUBLIC cxx_std_23)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:hf_build_flags>)
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name} CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "$ORIGIN" VERIFY_INTERFACE_HEADER_SETS ON)
  install(TARGETS ${target} EXPORT hybridfusionTargets FILE_SET HEADERS COMPONENT dev
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT dev ARCHIVE COMPONENT dev)
endfunction()

function(hf_add_tests name)
  if(NOT HF_BUILD_TESTS)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  find_package(GTest REQUIRED)
  include(GoogleTest)
  add_executable(hf_${name}_test ${ARG_SOURCES})
  target_link_libraries(hf_${name}_test PRIVATE hybridfusion::${name} GTest::gmock GTest::gtest_main ${ARG_LIBRARIES}
                        hf_build_flags)
  target_include_directories(hf_${name}_test PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  # The tests of optimised code need no optimisation themselves: a third of the build's time.
  target_compile_options(hf_${name}_test PRIVATE $<$<CONFIG:Release>:-O1>)
  gtest_discover_tests(hf_${name}_test PROPERTIES LABELS "unit;${name}" DISCOVERY_MODE PRE_TEST)
endfunction()
