# Builds web/dist/index.html and copies it to PAGE. Run by cmake/page.cmake with NPM, WEB and PAGE. A page that cannot
# be built does not stop the build: PAGE is then an empty line, so old that the next build tries again.

function(call what)
  execute_process(COMMAND ${NPM} ${ARGN} WORKING_DIRECTORY ${WEB}
                  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status EQUAL 0)
    set(failed "" PARENT_SCOPE)
  else()
    message(WARNING "The report page was not built: ${what} failed.\n${output}\n"
                    "Terp works without it, but `terp report` shows nothing. Try: cd web && npm ${ARGN}")
    set(failed ${what} PARENT_SCOPE)
  endif()
endfunction()

# Packages are fetched again only when the list of them has changed.
file(SHA256 ${WEB}/package-lock.json wanted)
set(stamp ${WEB}/node_modules/.terp-lock)
set(there "")
if(EXISTS ${stamp})
  file(READ ${stamp} there)
endif()
set(failed "")
if(NOT there STREQUAL wanted)
  call("fetching its packages" ci)
  if(NOT failed)
    file(WRITE ${stamp} ${wanted})
  endif()
endif()
if(NOT failed)
  call("compiling it" run build)
endif()
if(failed)
  file(WRITE ${PAGE} "\n")
  execute_process(COMMAND touch -d @0 ${PAGE})
else()
  configure_file(${WEB}/dist/index.html ${PAGE} COPYONLY)
  file(TOUCH ${PAGE})
endif()
