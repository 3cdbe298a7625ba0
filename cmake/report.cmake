# The report's viewer is built by web/build.mjs and committed; here it becomes a part of the compare stage.
set(report_html ${PROJECT_SOURCE_DIR}/web/dist/report.html)
set(report_source ${PROJECT_BINARY_DIR}/generated/report_template.cpp)
add_custom_command(
  OUTPUT ${report_source}
  COMMAND ${CMAKE_COMMAND} -DINPUT=${report_html} -DOUTPUT=${report_source}
          -DHEADER=compare/report/report_template.h -DFUNCTION=report_template
          -P ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
  DEPENDS ${report_html} ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake)
target_sources(mrsim_compare PRIVATE ${report_source})
target_compile_definitions(mrsim_compare PRIVATE MRSIM_VERSION="${PROJECT_VERSION}")
