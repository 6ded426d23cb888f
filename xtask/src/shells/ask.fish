# Words that fish proposes for a line, of which the file in $1 holds the completions: `fish ask.fish SCRIPT LINE`.
source $argv[1]
complete -C $argv[2] | string replace -r '\t.*' ''
# `string replace` fails where no word has a help
exit 0
