# Completion for bash: the subcommands, the options of a subcommand as its --help lists them, and else files.
_surface_mesh_geodesics()
{
  local program=$1 word=$2
  local options='s/^  \(-[a-z] \[ \)\{0,1\}\(--[a-z0-9-]*\).*/\2/p'
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    local subcommands
    subcommands=$("$program" --help 2> /dev/null | sed -n '/^subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "$subcommands --help --version" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("$program" "${COMP_WORDS[1]}" --help 2> /dev/null | sed -n "$options")" \
      -- "$word")
  fi
}
complete -o default -F _surface_mesh_geodesics surface_mesh_geodesics
