# Manual and completion, filled from the table of options (src/core/words/option_table.cpp).
add_executable(option_texts cmake/option_texts.cpp)
target_link_libraries(option_texts PRIVATE mrsim_core mrsim_flags)
function(mrsim_option_text kind template output)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/${output}
    COMMAND option_texts ${kind} ${PROJECT_SOURCE_DIR}/${template} ${PROJECT_BINARY_DIR}/${output}
      ${PROJECT_VERSION}
    DEPENDS option_texts ${PROJECT_SOURCE_DIR}/${template} VERBATIM)
endfunction()
mrsim_option_text(manual docs/mrsim.1.in share/mrsim.1)
mrsim_option_text(completion scripts/completion.bash.in share/completion.bash)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share)
add_custom_target(mrsim_option_texts ALL
  DEPENDS ${PROJECT_BINARY_DIR}/share/mrsim.1 ${PROJECT_BINARY_DIR}/share/completion.bash)
