# SPDX-License-Identifier: MIT
# The table of defaults in docs/adaptive.md names every parameter of AdaptiveParams with the value the headers give it.
set -u
source=$2
learn=$source/include/sspql/learn
page=$source/docs/adaptive.md

members() { # prefix file struct: "prefix.name value" for each number or switch of the struct
    awk -v prefix="$1" -v struct="$3" '
        $0 ~ "^struct " struct " \\{" { inside = 1 }
        /^};/ { inside = 0 }
        inside && /^    (double|bool|std::uint64_t|StepBudget) [a-z_]+( = |\{).*;/ {
            name = $2
            sub(/\{.*/, "", name)
            value = $0
            sub(/;.*/, "", value)
            sub(/^[^={]*(= )?/, "", value)
            if (value ~ /^[0-9]+\.0$/) sub(/\.0$/, "", value)
            print prefix name "|" value
        }
    ' "$2"
}

wanted=$(
    members '' "$learn/adaptive_params.hpp" AdaptiveParams
    members optimism. "$learn/adaptive/optimism_scale.hpp" OptimismParams
    members trust. "$learn/adaptive/forgetting_model.hpp" TrustParams
    members change. "$learn/adaptive/change_detector.hpp" ChangeParams
)
[ "$(printf '%s\n' "$wanted" | wc -l)" -ge 20 ] || { echo "the headers' defaults were not found"; exit 1; }
printf '%s\n' "$wanted" | {
    failures=0
    while IFS='|' read -r name value; do
        grep -qF "| \`$name\` | $value |" "$page" && continue
        echo "docs/adaptive.md lacks: $name = $value"
        failures=$((failures + 1))
    done
    exit "$failures"
}
