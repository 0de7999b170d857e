#!/bin/sh
# Counts the types that five ideas consist of: the closure of fixed roots over the packages of each idea.
# Usage: gradle/closures.sh [--list] FOLDER...   (folders of compiled classes; default: build/classes/java/main of all modules)
# A type's closure holds every type of ours in those packages that it or its nested types name, and, of an interface or
# class in it, every type in those packages that implements or extends it. Prints types without and with nested ones.
set -eu
list=
if [ "${1:-}" = --list ]; then list=1; shift; fi
if [ $# = 0 ]; then set -- $(ls -d "$(dirname "$0")"/../*/build/classes/java/main); fi
path=$(printf '%s:' "$@")
{
  jdeps -v -cp "$path" "$@" 2>/dev/null | awk '$2 == "->" && $1 ~ /^nephele/ && $3 ~ /^nephele/ { print "uses", $1, $3 }'
  find "$@" -name '*.class' ! -name '*-info.class' | sort | xargs javap -p -cp "$path" 2>/dev/null |
    sed -n 's/^[^(]*\(class\|interface\) \(nephele[^ <]*\)[^{]* *\(extends\|implements\) \(.*\) {$/\2 \4/p' |
    sed 's/<[^<>]*>//g; s/<[^<>]*>//g; s/<[^<>]*>//g; s/implements//; s/,/ /g' |
    awk '{ for (i = 2; i <= NF; i++) if ($i ~ /^nephele/) print "is", $1, $i }'
} | awk -v list="$list" '
  function package(type) { sub(/\.[^.]*$/, "", type); return type }
  function top(type) { sub(/\$.*/, "", type); return type }
  function within(type, words,   i, count, word, name) {
    name = package(type)
    count = split(words, word, " ")
    for (i = 1; i <= count; i++)
      if (name == "nephele." word[i] || word[i] ~ /\*$/ && index(name, "nephele." substr(word[i], 1, length(word[i]) - 1)) == 1)
        return 1
    return 0
  }
  function idea(name, roots, packages,   root, count, i, j, found, open, type, next_, tops, all, allTops) {
    split("", found); split("", open); split("", tops)
    count = split(roots, root, " ")
    last = 0
    for (i = 1; i <= count; i++) {
      if (!(("nephele." root[i]) in known)) print "  no class nephele." root[i]
      for (type in known) if (top(type) == "nephele." root[i]) { found[type] = 1; open[++last] = type }
    }
    for (i = 1; i <= last; i++) {
      type = open[i]
      count = split(leads[type], next_, " ")
      for (j = 1; j <= count; j++)
        if (!(next_[j] in found) && within(next_[j], packages)) { found[next_[j]] = 1; open[++last] = next_[j] }
    }
    all = allTops = 0
    for (type in found) { all++; if (!(top(type) in tops)) { tops[top(type)] = 1; allTops++ } }
    printf "%-22s %4d types, %4d with nested\n", name, allTops, all
    if (list) for (type in tops) print "  " type | "sort"
    if (list) close("sort")
  }
  { known[$2] = known[$3] = 1
    leads[$2] = leads[$2] " " $3
    if ($1 == "is") leads[$3] = leads[$3] " " $2 }
  END {
    idea("one frame", "engine.render.Renderer", "engine.render engine.render.frame engine.render.resource")
    idea("one tick", "engine.sim.Simulation", "engine.sim* engine.collision* engine.portal*")
    idea("a marched cloud", "engine.render.pass.cloud.volume.VolumeTechnique", "engine.cloud* engine.render.pass.cloud*")
    idea("a portal placed", "engine.portal.placement.Placement", "engine.portal*")
    idea("a drag of the editor", "editor.tool.transform.TransformTool editor.tool.select.SelectTool", "editor.tool* editor.document editor.brush editor.session")
  }'
