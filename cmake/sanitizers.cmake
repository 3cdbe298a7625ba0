if(MRSIM_SANITIZE)
  add_compile_options(-fsanitize=${MRSIM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MRSIM_SANITIZE})
endif()
