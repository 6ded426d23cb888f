# Completions of cdpr for bash. `cdpr complete` knows what may stand where; this hands it the words and reads its answer.

_cdpr() {
    local line="${COMP_LINE:0:$COMP_POINT}" blank part i
    local -a words=()
    # bash parts words at `=` and `:` too: what no blank parts is one word
    for ((i = 0; i <= COMP_CWORD; i++)); do
        blank="${line%%[![:blank:]]*}"
        line="${line#"$blank"}"
        part="${COMP_WORDS[i]}"
        ((i == COMP_CWORD)) && part="$line"
        line="${line#"$part"}"
        if [[ -n $blank || ${#words[@]} -eq 0 ]]; then
            words+=("$part")
        else
            words[${#words[@]} - 1]+="$part"
        fi
    done
    local typed="${words[${#words[@]} - 1]}" answer files ending entry
    COMPREPLY=()
    answer="$("${1/#\~/$HOME}" complete -- "${words[@]:1}" 2>/dev/null)" || return
    {
        read -r files ending
        while IFS=$'\t' read -r entry _; do
            COMPREPLY+=("$entry")
        done
    } <<<"$answer"
    [[ $ending == open ]] && compopt -o nospace 2>/dev/null

    # the part of the word that bash leaves as it is; within quotes it parts nothing
    local breaks="${COMP_WORDBREAKS//[^=:]/}" kept=""
    if [[ $typed == [\'\"]* ]]; then
        typed="${typed#?}"
    elif [[ -n $breaks && $typed == *[$breaks]* ]]; then
        kept="${typed%"${typed##*[$breaks]}"}"
        ((${#COMPREPLY[@]})) && COMPREPLY=("${COMPREPLY[@]#"$kept"}")
    fi

    if [[ $files != none ]]; then
        local option="" path="$typed"
        if [[ $typed == --*=* ]]; then
            option="${typed%%=*}=" path="${typed#*=}"
        fi
        [[ $ending == open ]] || compopt -o filenames 2>/dev/null
        while IFS= read -r entry; do
            if [[ $files == any || -d ${entry/#\~/$HOME} || $files == .* && $entry == *"$files" ]]; then
                entry="$option$entry"
                COMPREPLY+=("${entry#"$kept"}")
            fi
        done < <(compgen -f -- "$path")
    fi
}

complete -o nosort -F _cdpr cdpr 2>/dev/null || complete -F _cdpr cdpr
