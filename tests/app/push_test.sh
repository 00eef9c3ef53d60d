#!/usr/bin/env bash
# Results on their way to a learning record store, from outside: only of those who consent, each once, whatever the store
# does meanwhile. $FULCRUM is the program, $RECORD_STORE the stand-in for a store.
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted
export XDG_DATA_HOME=$work/data

# serve ARGS...: starts the store; $port is where it listens.
serve() {
  coproc STORE { "$RECORD_STORE" "$@"; }
  read -r port <&"${STORE[0]}"
}
# It ends with its input.
end() {
  local input=${STORE[1]} process=$STORE_PID
  exec {input}>&-
  wait "$process"
}
push() { "$FULCRUM" results --push "$@" --credentials secret; }
lines() { grep -c . "$1" 2>/dev/null || true; }

printf 'teacher:secret: of 3 words\n' >secret
chmod 600 secret
for person in P1 P1 P2; do "$FULCRUM" run stick --headless --participant $person >/dev/null 2>&1 || fail "no trial"; done
"$FULCRUM" run stick --headless --seconds 0.2 --participant P1 >/dev/null 2>&1 # ended early: it is not sent

# --- nothing without consent; then of those who consent, each once, however often it is asked for
serve accepted
expect 0 '^0 sent' push "http://localhost:$port/xapi"
"$FULCRUM" results --consents P1 >/dev/null
expect 0 '^2 sent' push "http://localhost:$port/xapi/"
expect 0 '^0 sent' push "http://localhost:$port/xapi"
[ "$(lines accepted)" = 2 ] || fail "the store has $(lines accepted) statements, not 2"
grep -q "$work" accepted && fail "a folder of this machine was sent"
grep -q P2 accepted && fail "somebody was sent who does not consent"
first=$port
end

# --- a store that is away keeps its results waiting, and the same command goes on
"$FULCRUM" results --consents P2 >/dev/null
expect 1 '1 waiting' push "http://localhost:$first/xapi"
# Another store, over TLS, unwell at first: it is tried again. Its authority is nobody's that the system trusts.
mkdir tls
serve --tls tls --fail 2 encrypted
expect 1 'certificate' push "https://localhost:$port/xapi"
expect 0 '^3 sent' push "https://localhost:$port/xapi" --certificates tls/certificate.pem
[ "$(lines encrypted)" = 3 ] || fail "over TLS the store has $(lines encrypted) statements, not 3"
expect 0 '^0 sent' push "https://localhost:$port/xapi" --certificates tls/certificate.pem
end

# --- what is refused before anything is sent
expect 1 'https' push http://example.com/xapi
expect 2 'belong together' "$FULCRUM" results --push http://localhost:1/xapi
chmod 644 secret
expect 1 'chmod 600' push http://localhost:1/xapi
expect 2 'one thing at a time' "$FULCRUM" results --push http://localhost:1 --credentials secret --participants
[ "$failures" = 0 ] || exit 1
echo "all good"
