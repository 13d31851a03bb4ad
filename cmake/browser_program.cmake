# The program as WebAssembly, for a page of a browser (docs/browser.md): compiled with the toolchain file
# cmake/browser.cmake. The SSE2 kernels become its instructions for vectors, in the same bits.
# Warnings of clang about the twins stop nothing: `make lint` has those of all other files.
add_compile_options(-fwasm-exceptions -msimd128 -msse2 -Wno-error)

# What emscripten writes: terp.js, a function that makes the program anew, and terp.wasm. Of an inline function the
# linker takes the first copy. What a step spends its time in comes first: the copies of the other layers, compiled to
# be small, take 3.4 times as long.
function(link_browser_program target)
  target_link_options(${target} PRIVATE -Wl,--whole-archive $<TARGET_FILE:terp_mpm> $<TARGET_FILE:terp_soil>
    $<TARGET_FILE:terp_math> -Wl,--no-whole-archive)
  target_link_options(${target} PRIVATE -O2 -fwasm-exceptions -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB
    -sSTACK_SIZE=4MB -sINITIAL_MEMORY=64MB -sMODULARIZE=1 -sEXPORT_NAME=Terp -sINVOKE_RUN=0 -sEXIT_RUNTIME=0
    -sFORCE_FILESYSTEM=1 -sDYNAMIC_EXECUTION=0 -sENVIRONMENT=node,worker
    -sEXPORTED_RUNTIME_METHODS=FS,callMain
    -sEXPORTED_FUNCTIONS=_main,_terp_go_on,_terp_time,_terp_stop)
endfunction()
