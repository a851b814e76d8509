# SPDX-License-Identifier: MIT
# For scripts that compare what two ways to run a program wrote.

# What must be the same of the files NAME.*: all but measured times and the command in the report's footer.
comparable() {
    for part in "$1".*; do
        case $part in
        *.json) sed -i '/^  "timing": /,$d' "$part" ;;
        # ns/step is the last column of a table.
        *.html) sed -i -e '/^<dt>command<\/dt>/d' -e 's|<td class="number">[0-9.]*</td></tr>|</tr>|' "$part" ;;
        esac
        [ "$(wc -c <"$part")" -gt 100 ] || {
            echo "$part: next to nothing to compare"
            exit 1
        }
    done
}
