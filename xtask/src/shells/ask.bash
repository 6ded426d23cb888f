# Words that bash proposes for a line, of which the file in $1 holds the completions: `bash ask.bash SCRIPT LINE`.
source "$1" || exit
COMP_LINE="$2" COMP_POINT="${#2}" COMP_WORDS=() COMP_WORDBREAKS=$' \t\n"\'><=;|&(:'
# as readline parts it: blanks part words, and `=` and `:` are words unless they are quoted
rest="$2"
while [[ -n $rest ]]; do
    rest="${rest#"${rest%%[! ]*}"}"
    case $rest in
        [\'\"]*) word="$rest" ;;
        [=:]*) word="${rest%%[!=:]*}" ;;
        *) word="${rest%%[ =:]*}" ;;
    esac
    COMP_WORDS+=("$word")
    rest="${rest#"$word"}"
    [[ $rest == ' ' ]] && COMP_WORDS+=('') && break
done
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_cdpr cdpr
((${#COMPREPLY[@]})) && printf '%s\n' "${COMPREPLY[@]}"
exit 0
