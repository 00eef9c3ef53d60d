#!/usr/bin/env bash
# schema_test.sh TOP: the schemas that editors read. They are those of the program, and what is shipped holds to them, as a
# validator says that shares nothing with the program. $FULCRUM.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
top=$(readlink -f "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for kind in scenario hand device material; do
  "$FULCRUM" schema $kind >"$work/$kind.json"
  cmp -s "$work/$kind.json" "$top/content/schema/$kind.json" ||
    fail "content/schema/$kind.json is not the program's: fulcrum schema $kind >content/schema/$kind.json"
done
"$FULCRUM" schema page >"$work/keys.md"
cmp -s "$work/keys.md" "$top/docs/keys.md" || fail "docs/keys.md is not the program's: fulcrum schema page >docs/keys.md"

# --- files that are right, and slips that an editor shall underline
cat >"$work/validate.py" <<'PYTHON'
import json, os, re, sys
import jsonschema, yaml

class Loader(yaml.SafeLoader):
    pass
# YAML 1.2 has 1e-3 as a number, which YAML 1.1 takes for text.
Loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?(\.\d+|\d+(\.\d*)?)([eE][-+]?\d+)$"), list("-+.0123456789"))

def load(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    named = re.match(r"# yaml-language-server: \$schema=(\S+)\n", text)
    if not named:
        sys.exit(f"{path} does not name its schema in its first line")
    schema = os.path.join(os.path.dirname(path), named.group(1))
    with open(schema, encoding="utf-8") as file:
        return yaml.load(text, Loader), json.load(file)

bad = 0
judged = 0
for folder, _, names in os.walk(os.path.join(sys.argv[1], "content")):
    for name in sorted(names):
        if not name.endswith(".yaml"):
            continue
        path = os.path.join(folder, name)
        value, schema = load(path)
        jsonschema.Draft202012Validator.check_schema(schema)
        for error in jsonschema.Draft202012Validator(schema).iter_errors(value):
            bad += 1
            print(f"FAILED: {path}: {'.'.join(map(str, error.absolute_path))}: {error.message[:200]}")
        judged += 1
if judged < 40:
    sys.exit(f"only {judged} files were judged")

value, schema = load(os.path.join(sys.argv[1], "content/scenarios/piping/scenario.yaml"))
def slip(change):
    global bad
    wrong = json.loads(json.dumps(value))
    change(wrong)
    if jsonschema.Draft202012Validator(schema).is_valid(wrong):
        bad += 1
        print("FAILED: a slip is not seen:", change.__doc__)
def unknown(v):
    "an unknown key"
    v["contact"]["stifness"] = 1
def text(v):
    "text for a number"
    v["time_limit"] = "long"
def range_(v):
    "a number out of its range"
    v["contact"]["stiffness"] = -1
def missing(v):
    "a missing key"
    del v["tool"]["start"]
def word(v):
    "a word that is none of those there are"
    v["models"]["piping"]["role"] = "scenery"
def short(v):
    "two numbers for three"
    v["checkpoints"][0]["position"] = [0, 0]
for each in (unknown, text, range_, missing, word, short):
    slip(each)
sys.exit(bad > 0)
PYTHON
/usr/bin/python3 "$work/validate.py" "$top" || fail "a public validator finds something"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
