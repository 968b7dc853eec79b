# docs_text: the pages of docs/ that are made from the code, anew. Tests hold them against the code.
find_program(DOCS_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
add_custom_target(docs_text
  COMMAND ${DOCS_PYTHON} ${PROJECT_SOURCE_DIR}/cmake/docs.py write $<TARGET_FILE:stickslip>
  COMMENT "docs/reference.md, docs/method.md" VERBATIM)
add_dependencies(docs_text stickslip)
# docs: those, the pictures that the program draws for the pages, and the site where mkdocs is installed
add_custom_target(docs
  COMMAND ${DOCS_PYTHON} ${PROJECT_SOURCE_DIR}/cmake/docs.py site $<TARGET_FILE:stickslip> ${PROJECT_BINARY_DIR}/site
  COMMENT "pages and pictures" VERBATIM)
add_dependencies(docs docs_text)
