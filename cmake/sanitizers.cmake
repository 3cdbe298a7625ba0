# Sanitized builds run the presets asan and tsan of CMakePresets.json: optimised a little (-O1), or the heavy headers would run for
# minutes; sources compiled together. Their tests need options, which stand in the test presets. intercept_tls_get_addr=0: GCC's runtime
# takes some blocks of a module's thread-local variables for those of an old glibc and reads beyond them at the end ("Tracer caught
# signal 11").
if(MRSIM_SANITIZE)
  add_compile_options(-fsanitize=${MRSIM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(MRSIM_FUZZ AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    add_compile_options(-fsanitize=fuzzer-no-link)
  endif()
  add_link_options(-fsanitize=${MRSIM_SANITIZE})
endif()
