# The report page (web/): built with Node.js when this is here, and put into the program, so that who has the program
# needs no Node.js. Without Node.js, or where its packages cannot be fetched, Terp is built all the same; `terp report`
# then says that it has no page.

option(TERP_PAGE "Build the report page (web/) and put it into the program; needs Node.js and npm" ON)

# Adds the page, or an empty line in its place, to a target.
function(add_page target)
  if(EMSCRIPTEN)  # the page that runs it has the template (src/page/page_template_wasm.cpp)
    return()
  endif()
  find_program(TERP_NPM npm)
  find_program(TERP_NODE node)
  set(page ${PROJECT_BINARY_DIR}/page/page.html)
  if(TERP_PAGE AND TERP_NPM AND TERP_NODE)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/src/*)
    list(APPEND sources ${PROJECT_SOURCE_DIR}/web/index.html ${PROJECT_SOURCE_DIR}/web/vite.config.ts
         ${PROJECT_SOURCE_DIR}/web/tsconfig.json)
    set(build ${CMAKE_COMMAND} -DNPM=${TERP_NPM} -DWEB=${PROJECT_SOURCE_DIR}/web -DPAGE=${page}
              -P ${PROJECT_SOURCE_DIR}/cmake/build_page.cmake)
    add_custom_command(OUTPUT ${page} COMMAND ${build} DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/web/package-lock.json
                       ${PROJECT_SOURCE_DIR}/cmake/build_page.cmake COMMENT "Building the report page" VERBATIM)
  else()
    if(TERP_PAGE)
      message(WARNING "node and npm were not found: `terp report` will have no page to show its data. "
                    "tools/install-dependencies installs them.")
    endif()
    file(WRITE ${page} "\n")
  endif()
  set(object ${PROJECT_BINARY_DIR}/page/page.o)
  set(options -z noexecstack)
  if(WIN32)  # whose object files say nothing of stacks
    set(options "")
  endif()
  add_custom_command(OUTPUT ${object} COMMAND ${CMAKE_LINKER} -r -b binary ${options} -o ${object} page.html
                     WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/page DEPENDS ${page}
                     COMMENT "Putting the report page into the program" VERBATIM)
  link_object(${target} ${object})
endfunction()
