#compdef cdpr
# Completions of cdpr for zsh. `cdpr complete` knows what may stand where; this hands it the words and reads its answer.

_cdpr() {
    local -a lines whole going
    local files ending line word help
    lines=("${(@f)$("${(Q)words[1]/#\~/$HOME}" complete -- "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2>/dev/null)}")
    files="${lines[1]%% *}" ending="${lines[1]##* }"
    shift lines
    for line in "${(@)lines}"; do
        [[ -n $line ]] || continue
        word="${line%%$'\t'*}" help="${line#*$'\t'}"
        line="${word//:/\\:}${help:+:$help}"
        if [[ $word == *[=:,+\[] ]]; then going+=("$line"); else whole+=("$line"); fi
    done
    local ret=1
    (( $#going )) && _describe -V cdpr going -S '' && ret=0
    # the blank after a word that may go on vanishes when it does
    if [[ $ending == open ]]; then
        (( $#whole )) && _describe -V cdpr whole -S ' ' -r $'+,:;=[ \t\n' && ret=0
    else
        (( $#whole )) && _describe -V cdpr whole && ret=0
    fi
    if [[ $files != none ]]; then
        [[ $PREFIX == --*=* ]] && compset -P 1 '*='
        case $files in
            any) _files && ret=0 ;;
            folders) _files -/ && ret=0 ;;
            .*) _files -g "*$files(-.)" && ret=0 ;;
        esac
    fi
    return ret
}

if [ "$funcstack[1]" = "_cdpr" ]; then
    _cdpr "$@"
else
    compdef _cdpr cdpr
fi
