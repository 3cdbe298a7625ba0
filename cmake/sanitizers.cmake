# Sanitized builds run the presets asan and tsan of CMakePresets.json: optimised a little (-O1), or the heavy headers would run for
# minutes; sources compiled together. Their tests need options, which stand in the test presets. intercept_tls_get_addr=0: GCC's runtime
# takes some blocks of a module's thread-local variables for those of an old glibc and reads beyond them at the end ("Tracer caught
# signal 11").
#
# UBSan's checks of each access (null, alignment, object-size, vptr) and of each step of a pointer (pointer-overflow) are left out: they
# take a third of all compile time, and AddressSanitizer sees the access that they announce. Steps of pointers are four fifths of what UBSan
# records, half a million addresses in the library, which each start of the program would have to relocate. What AddressSanitizer does not
# see, a pointer cast to a type of larger alignment, is a warning of the compiler (-Wcast-align=strict, warnings.cmake).
#
# mrsim_unsanitized() names sources of a target that are little but headers of CGAL or OpenVDB, which take a minute each with the checks.
# Their tests are slow ones, left out: nothing is optimised, or the objects of the other build serve (MRSIM_PLAIN_BUILD).
if(MRSIM_SANITIZE)
  add_compile_options(-fsanitize=${MRSIM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(MRSIM_SANITIZE MATCHES undefined)
    add_compile_options(-fno-sanitize=null,alignment,object-size,vptr,pointer-overflow)
  endif()
  if(MRSIM_FUZZ AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    add_compile_options(-fsanitize=fuzzer-no-link)
  endif()
  add_link_options(-fsanitize=${MRSIM_SANITIZE})
endif()

function(mrsim_unsanitized target)
  if(NOT MRSIM_SANITIZE)
    return()
  endif()
  if(NOT MRSIM_PLAIN_BUILD)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=all -O0)
    return()
  endif()
  set_source_files_properties(${ARGN} PROPERTIES HEADER_FILE_ONLY TRUE)
  foreach(source ${ARGN})
    set(object ${MRSIM_PLAIN_BUILD}/CMakeFiles/${target}.dir/${source}.o)
    if(NOT EXISTS ${object})
      message(FATAL_ERROR "${object} is missing: ./setup test ci first")
    endif()
    set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT TRUE)
    target_sources(${target} PRIVATE ${object})
  endforeach()
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
endfunction()
