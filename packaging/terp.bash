# Completion of terp for bash: commands and options as `terp --help` prints them, names of files, topics of explain.
_terp()
{
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ] || { [ "$command" = help ] && [ "$COMP_CWORD" -eq 2 ]; }; then
    words=$("${COMP_WORDS[0]}" --help 2>/dev/null | sed -n 's/^  \([a-z]\{2,\}\) .*  .*/\1/p')
    COMPREPLY=($(compgen -W "$words help --help --version" -- "$word"))
  elif [[ $word == -* ]]; then
    words=$("${COMP_WORDS[0]}" "$command" --help 2>/dev/null | grep -oE '^  (-[a-z], )?--[a-z-]+' | grep -oE -- '--?[a-z-]+')
    COMPREPLY=($(compgen -W "$words --help" -- "$word"))
  elif [ "$command" = explain ]; then
    words=$("${COMP_WORDS[0]}" list 2>/dev/null | sed -n 's/^  \([a-z_]\{2,\}\) .*/\1/p')
    COMPREPLY=($(compgen -W "$words time mesh body material forces initial boundary water flood load stage method output" \
      -- "$word"))
  elif [ "$before" = --set ]; then
    return
  else
    compopt -o filenames
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -F _terp terp
