#!/bin/sh
# Says how old the rows of docs/proofs.md are: for each proof the commits since the row's own that touched one of its packages.
# Usage: gradle/proofs.sh   (in a checkout with its history)
# A proof's packages are its own and those that its class imports, and the classes of its package that it names. Failing rows come
# first, then the rows with the most commits; "?" stands for a commit that this history does not have.
set -eu
cd "$(dirname "$0")/.."
proofs=workshop/src/main/java/nephele/workshop/prove

# The source files of a proof: the class that has its name as a string, and the classes beside it that this one names.
files_of() {
  for class in $(grep -rlF "\"$1\"" --include='*.java' "$proofs" | grep -v '/Proofs\.java$'); do
    echo "$class"
    for beside in "$(dirname "$class")"/*.java; do
      if grep -qw "$(basename "$beside" .java)" "$class"; then echo "$beside"; fi
    done
  done | sort -u
}

# The folders of the packages that the files import, sources and resources, and of the files themselves.
folders_of() {
  {
    for file; do dirname "$file"; done
    sed -n 's/^import \(static \)\{0,1\}\(nephele\.[a-z.]*\)\.[A-Z].*/\2/p' "$@" | sort -u |
      while read -r package; do
        module=$(echo "$package" | cut -d. -f2)
        path=$(echo "$package" | tr . /)
        for folder in "$module/src/main/java/$path" "$module/src/main/resources/$path"; do
          if [ -d "$folder" ]; then echo "$folder"; fi
        done
      done
  } | sort -u | grep -v '/prove/proof$'
}

grep '^| ' docs/proofs.md | grep -v '^| proof |' |
  while IFS='|' read -r _ name _ _ failures _ date commit _; do
    name=$(echo "$name" | tr -d ' ')
    commit=$(echo "$commit" | tr -d ' +')
    since='?'
    files=$(files_of "$name")
    if [ -n "$files" ] && git cat-file -e "$commit^{commit}" 2>/dev/null; then
      # shellcheck disable=SC2046,SC2086
      since=$(git log --oneline "$commit..HEAD" -- $(for folder in $(folders_of $files); do echo ":(glob)$folder/*"; done) | wc -l)
    fi
    echo "$([ "$failures" -gt 0 ] && echo fails || echo holds) $since $name $(echo "$date" | tr -d ' ') $commit"
  done | sort -k1,1 -k2,2nr |
  awk '{ printf "%-18s %-5s %5s commits since %s (%s)\n", $3, $1, $2, $4, $5 }'
