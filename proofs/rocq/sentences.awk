# Prints each sentence of a Coq file that assumes something or leaves something
# open.  Comments (nested) and strings are dropped; a sentence ends with a full
# stop before white space.  `file` is the name to print.
{ text = text $0 "\n" }
END {
  n = length(text); depth = 0; string = 0; sentence = ""; line = 1; first = 0
  for (i = 1; i <= n; i++) {
    ch = substr(text, i, 1); two = substr(text, i, 2)
    if (ch == "\n") line++
    if (string) { if (ch == "\"") string = 0; continue }
    if (two == "(*") { depth++; i++; continue }
    if (depth > 0) { if (two == "*)") { depth--; i++ } else if (ch == "\"") string = 1; continue }
    if (ch == "\"") { string = 1; continue }
    if (ch == "." && substr(text, i + 1, 1) ~ /[ \t\n]/) {
      judge(sentence, first); sentence = ""; first = 0; continue
    }
    if (!first && ch !~ /[ \t\n]/) first = line
    sentence = sentence (ch == "\n" ? " " : ch)
  }
  if (sentence ~ /[^ \t]/) print file ":" first ": unfinished sentence"
  if (open > 0) print file ": section or module not closed"
}
function judge(s, at,   word) {
  gsub(/[ \t]+/, " ", s)
  # Bullets, braces, attributes and prefixes before the command.
  while (sub(/^( |[-+*{}]|#\[[^]]*\] ?|(Local|Global|Polymorphic|Monomorphic|Cumulative|Private|Program|Time|Redirect|Fail|Succeed) )/, "", s)) ;
  word = s; sub(/[^A-Za-z_].*/, "", word)
  if (word == "Section") { kinds[++open] = "section"; inside++ }
  else if (word == "Module" && s !~ /:=/) kinds[++open] = "module"
  else if (word == "End" && open > 0) { if (kinds[open] == "section") inside--; open-- }
  if (s ~ /^(Axioms?|Parameters?|Conjectures?|Primitive|Symbols?|Rewrite Rules?|Declare (ML )?Module|Module Type|Admit|Admitted)([^A-Za-z_]|$)/)
    print file ":" at ": assumes: " substr(s, 1, 60)
  if (word ~ /^(Variables?|Hypothes[ie]s|Context|Let)$/ && !inside && s !~ /^Let [^:]*:=/)
    print file ":" at ": outside a section: " substr(s, 1, 60)
  if (s ~ /(^|[^A-Za-z_])(admit|Admitted|give_up|bypass_check|native_cast_no_check|vm_cast_no_check)([^A-Za-z_]|$)/)
    print file ":" at ": leaves open: " substr(s, 1, 60)
  if (s ~ /^(Unset|Set) .*(Guard|Positivity|Universe|Type In Type|Bypass|Impredicative)/)
    print file ":" at ": switches off a check: " substr(s, 1, 60)
}
