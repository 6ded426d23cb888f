# Words that zsh proposes for a line, of which the file in $1 holds the completions: `zsh -f ask.zsh SCRIPT LINE`.
#
# Completion functions run in an interactive shell alone: another zsh is one, which prints what reaches `compadd` between two lines.
zmodload zsh/zpty || exit
script=$1 line=$2
setup=$(mktemp) || exit
cat >$setup <<'END'
PROMPT= PS2= RPROMPT=
unsetopt zle_bracketed_paste 2>/dev/null
autoload -Uz compinit && compinit -u -D
source $CDPR_COMPLETIONS
bindkey '^M' undefined
bindkey '^J' undefined
bindkey '^I' complete-word
zstyle ':completion:*' list-grouped false
zstyle ':completion:*' insert-tab false
compadd() {
    # helpers that ask `compadd` for arrays (-O, -A, -D) add nothing
    if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then
        builtin compadd "$@"
        return
    fi
    typeset -a hits
    builtin compadd -A hits "$@"
    typeset -A removed kept
    zparseopts -E P:=removed p:=kept
    local hit
    for hit in $hits; do
        print -r -- "hit:$removed[-P]$kept[-p]$hit"
    done
    # `_files` goes on to other files where none is added
    builtin compadd "$@"
}
before() { print -r -- 'hits begin' }
after() { print -r -- 'hits end'; exit }
compprefuncs=(before)
comppostfuncs=(after)
print -r -- ready
END
export CDPR_COMPLETIONS=$script
zpty asked zsh -f -i
zpty -w asked "source $setup"
while zpty -r asked answer; do
    [[ $answer == ready* ]] && break
done
zpty -w -n asked "$line"$'\t'
while zpty -r asked answer; do
    answer=${answer%$'\n'} answer=${answer%$'\r'}
    [[ $answer == hit:* ]] && print -r -- "${answer#hit:}"
    [[ $answer == *'hits end'* ]] && break
done
zpty -d asked 2>/dev/null
rm -f $setup
exit 0
