# What cmake/kernels.cmake does with ld and objcopy, for the object files of Windows. There a COMDAT is not a group but
# a mark on a section, which the linker keeps: a script merges the sections, and objcopy takes the mark off. Until then
# objcopy warns that the names of sections and symbols differ; its words are shown if it fails. What was in a COMDAT
# that the linker left out is a name without a place to it, although the same name has one: it joins the two the next
# time.
# The table for exceptions gets a name that `ld -r` does not know: .pdata it sorts by what stands in the entries before
# they are relocated, and leaves the relocations where they were (binutils 2.40). The last link takes .pdata* and sorts
# it as it must. A program with a wrong table loops for ever, or ends, when it throws (tools/check_unwind_table).
# Run with LINKER, OBJCOPY, OBJECTS, WHOLE, OBJECT and KEEP (names that stay global), lists separated by commas.
string(REPLACE "," ";" OBJECTS "${OBJECTS}")
string(REPLACE "," ";" KEEP "${KEEP}")
file(WRITE ${WHOLE}.ld "OUTPUT_FORMAT(pe-x86-64)
SECTIONS
{
  .text : { *(.text .text$* .text.*) }
  .rdata : { *(.rdata .rdata$*) }
  .data : { *(.data .data$*) }
  .bss : { *(.bss .bss$*) }
  .xdata : { *(.xdata .xdata$*) }
  .pdata$kernels : { *(.pdata .pdata$*) }
}
")
list(JOIN OBJECTS "\n" names)
file(WRITE ${WHOLE}.objects "${names}\n")  # too many for the command line of some systems
set(flags --set-section-flags .text=alloc,load,readonly,code,contents)
foreach(section .rdata .xdata .pdata$kernels)
  list(APPEND flags --set-section-flags ${section}=alloc,load,readonly,data,contents)
endforeach()
list(TRANSFORM KEEP PREPEND --keep-global-symbol=)
set(words "")
function(call)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "the kernels cannot be closed: ${words}${said}")
  endif()
  set(words "${words}${said}" PARENT_SCOPE)
endfunction()
call(${LINKER} -r -T ${WHOLE}.ld -o ${WHOLE} @${WHOLE}.objects)
call(${OBJCOPY} ${flags} ${WHOLE} ${WHOLE}.unmarked)
call(${LINKER} -r -T ${WHOLE}.ld -o ${WHOLE} ${WHOLE}.unmarked)
call(${OBJCOPY} ${KEEP} ${WHOLE} ${OBJECT})
