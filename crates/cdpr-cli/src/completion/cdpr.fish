# Completions of cdpr for fish. `cdpr complete` knows what may stand where; this hands it the words and reads its answer.

function __cdpr_complete
    set -l words (commandline -opc)
    set -l typed (commandline -ct)
    set -l lines ($words[1] complete -- $words[2..-1] "$typed" 2>/dev/null)
    set -l files (string split ' ' -- $lines[1])[1]
    for line in $lines[2..-1]
        echo $line
    end
    if test "$files" != none
        # the value of `--option=value` alone is a path
        set -l path (string replace -r '^--[^=]*=' '' -- "$typed")
        set -l option (string match -r '^--[^=]*=' -- "$typed")
        for entry in (__fish_complete_path "$path")
            set -l name (string split \t -- $entry)[1]
            switch $files
                case any
                    echo "$option$entry"
                case folders
                    string match -q '*/' -- $name; and echo "$option$entry"
                case '*'
                    string match -q -r '/$|\\'$files'$' -- $name; and echo "$option$entry"
            end
        end
    end
end

complete -c cdpr -e
complete -c cdpr -f -k -a '(__cdpr_complete)'
