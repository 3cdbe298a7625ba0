# Bash completion of mrsim.
_mrsim() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
  local program="--dialect --machine --tools --tool --start --block-skip --set --max-blocks --max-steps --comp --least-increments --path --strict"
  local common="--quiet --verbose --help --version"
  case $previous in
    --dialect) mapfile -t COMPREPLY < <(compgen -W "sinumerik iso fanuc codesys ngc" -- "$current"); return ;;
    --machine) mapfile -t COMPREPLY < <(compgen -W "mill lathe" -- "$current"); return ;;
    --keep) mapfile -t COMPREPLY < <(compgen -W "all largest" -- "$current"); return ;;
    --frames-by) mapfile -t COMPREPLY < <(compgen -W "time volume" -- "$current"); return ;;
    --color) mapfile -t COMPREPLY < <(compgen -W "line tool none" -- "$current"); return ;;
    --stock-exact) mapfile -t COMPREPLY < <(compgen -W "on off" -- "$current"); return ;;
    --path) mapfile -t COMPREPLY < <(compgen -d -- "$current"); return ;;
    --stock) mapfile -t COMPREPLY < <(compgen -W "box: cylinder: tube:" -f -- "$current"); return ;;
  esac
  if [[ $current == -* ]]; then
    case $command in
      trace) common="$program $common --output --json --programmed --variables" ;;
      check) common="$program $common --json" ;;
      rest) common="--output --json --voxel --above --deflection --threads --quiet --help" ;;
      tools) common="--output --json --quiet --help" ;;
      compare) common="$common --output --accept --align --density --deflection --report --json --junit --colors --path --threads --max-memory" ;;
      render) common="$common --output --frames --size --azimuth --elevation --up --edges --color --threads --nominal --accept --align --deflection --colors" ;;
      *) [ "$command" = view ] && common="$common --no-open"
        common="$program $common --output --color --stock --stock-exact --stock-repair --keep --until --frames --frames-by --history --rest --machine-file --allow-outside --voxel --tolerance --max-triangles --threads --max-memory --nominal --accept --align --density --deflection --report --json --junit --deviation --colors" ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$common" -- "$current")
  else
    local commands=""
    [ "$COMP_CWORD" -eq 1 ] && commands="trace check compare render rest tools view"
    mapfile -t COMPREPLY < <(compgen -W "$commands" -f -- "$current")
  fi
}
complete -o filenames -F _mrsim mrsim
