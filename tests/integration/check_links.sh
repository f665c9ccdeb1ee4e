#!/usr/bin/env bash
# check_links.sh REPOSITORY: every relative link of the Markdown pages leads to a file, and every page of docs/ has a place
# in mkdocs.yml. What scripts/docs makes (the API reference, the module graph) is excepted.
set -euo pipefail
cd "$1"
failed=0
while IFS= read -r page; do
  while IFS= read -r target; do
    case $target in http* | mailto:* | '#'* | ../api/index.html | module-graph.svg) continue ;; esac
    if [ ! -e "$(dirname "$page")/${target%%#*}" ]; then
      echo "$page: no such file: $target" >&2
      failed=1
    fi
  done < <(sed '/^```/,/^```/d' "$page" | grep -oE '\]\([^) ]+\)' | sed 's/^](//; s/)$//')
done < <(find README.md CONTRIBUTING.md CHANGELOG.md docs -name '*.md')
while IFS= read -r page; do
  grep -q ": ${page#docs/}\$" mkdocs.yml || {
    echo "$page has no place in mkdocs.yml" >&2
    failed=1
  }
done < <(find docs -name '*.md')
exit "$failed"
