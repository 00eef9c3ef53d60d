#!/usr/bin/env bash
# Voice coils on a sound card, from outside: what reaches a card, and what is said where there is none. $FULCRUM is the
# program; $CARD a plugin of ALSA that stands in for a card (tests/drivers_sound/card.cpp).
set -uo pipefail
. "$(dirname "$(readlink -f "$0")")/../support/expect.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export VK_ICD_FILENAMES=/nothing VK_DRIVER_FILES=/nothing # no picture is wanted

# A machine without a card, and one with some. `tape`: what reaches the card is in tape.raw; the card has always 7 ms ahead,
# however late a thread is.
touch none.conf
cat >some.conf <<END
pcm_type.stand_in { lib "$CARD" }
pcm.even { type stand_in ahead 336 }
pcm.tape { type file slave.pcm even file "$work/tape.raw" format raw }
pcm.default { type stand_in }
pcm.busy { type stand_in wrong busy }
pcm.slow { type stand_in rate 44100 }
pcm.short { type stand_in lasts 48000 }
END
export ALSA_CONFIG_PATH=$work/some.conf
run=("$FULCRUM" run sweep --headless --realtime --hand expert)

# --- what the card plays is what the WAVs have, sample by sample: where a busy machine had ticks left out, once more
frames() { od -An -v -t d2 "-w$1" | awk '{ print $1 + 0, $2 + 0 }'; }
sounding() { awk 'on || $1 != 0 || $2 != 0 { on = 1; print }'; }
said=
until grep -q 'ticks left out: 0, doubled: 0; gaps: 0; the card ran dry: 0' <<<"$said"; do
  rm -rf A tape.raw
  said=$("${run[@]}" --seconds 2 --device simulated+audio:tape --out A 2>&1) && fail "the sweep was completed in 2 s"
  grep -q 'Sound: ' <<<"$said" || { fail "no sound: $said"; break; }
done
grep -qE 'Sound: [0-9.]+ ms from a tick to the card.s output, at most [0-9.]+ ms' <<<"$said" || fail "no latency is told: $said"
for side in left right; do tail -c +45 A/vibrotactile_motion-$side.wav | frames 2 | cut -d' ' -f1 >$side; done
paste -d' ' left right | sounding >wavs
frames 4 <tape.raw | sounding >played
count=$(wc -l <wavs)
[ "$count" -gt 24000 ] || fail "only $count frames of the WAVs sound"
head -n "$count" played | cmp -s - wavs || fail "the card did not play what the WAVs have"
[ "$(tail -n 1 played)" = "0 0" ] || fail "the end is not silence: $(tail -n 1 played)"
grep -q '"device": "simulated+audio:tape"' A/summary.json || fail "the summary does not name the device"
tr -d '\n' <A/summary.json | sed -n 's/.*"sound_latency_ms": {[^0-9]*\([0-9.]*\)[^0-9]*\([0-9.]*\).*/\1 \2/p' |
  awk '{ good = $1 > 0 && $1 <= $2 } END { exit !good }' ||
  fail "the summary does not tell the latency of the sound"
grep -q '"hand": "expert"' A/summary.json || fail "the summary does not name the hand"

# --- it keeps time with a card that has a clock of its own, beside any simulated device, and is gone when it is unplugged
expect_each 3 'Sound: [0-9.]+ ms' 'Not completed' -- "${run[@]}" --seconds 1 --device simulated:two_channel+audio --out B
expect_each 4 'Sound: [0-9.]+ ms' -- "${run[@]}" --seconds 8 --device simulated+audio:short --out C
grep -q '"device_lost"\|lost' C/summary.json || fail "the summary does not say that a device was lost"

# --- nothing of it is built where nothing is driven
expect 3 'Not completed' "$FULCRUM" run knock --headless --realtime --seconds 0.5 --device simulated+audio --out D
"$FULCRUM" run knock --headless --realtime --seconds 0.5 --device simulated+audio --out E 2>&1 | grep -q Sound: && fail "sound without channels"
expect 0 'sound +device +left, right on audio:tape: a ring' "$FULCRUM" explain sweep --device mouse+audio:tape
expect 0 'sound +device +nothing in the scene drives the channels of audio' "$FULCRUM" explain knock --device mouse+audio
"$FULCRUM" explain sweep --device mouse | grep -qE '^ +sound ' && fail "sound where nobody asked for it"

# --- what cannot be had
expect 1 "'audio:busy' cannot be had: another program plays on it" "${run[@]}" --device simulated+audio:busy --out X
expect 1 "'audio:slow' cannot be had: it does not play 48000 samples a second, but 44100" "${run[@]}" --device simulated+audio:slow --out X
expect 1 "'audio:none' cannot be had: ALSA knows no PCM 'none'" "${run[@]}" --device simulated+audio:none --out X
expect 1 "'audio' vibrates by the clock.* add --realtime" "$FULCRUM" run sweep --headless --device simulated+audio --out X
expect 1 "'audio' moves nothing.*mouse.audio" "$FULCRUM" run sweep --device audio
# there NAME: `fulcrum devices` lists it before what is not there.
there() { "$FULCRUM" devices | sed '/^Not there/,$d' | grep -qE "^  $1 "; }
there audio || fail "audio is not listed as there"
there audio:PCM || fail "audio:PCM is not listed as there"
expect 0 '^sound +good +.*: 8 ms from a tick to its output, with periods of 2 ms' "$FULCRUM" doctor
export ALSA_CONFIG_PATH=$work/none.conf
expect 1 "'audio' cannot be had: no sound card is there: plug one in" "${run[@]}" --device simulated+audio --out X
there audio && fail "audio is listed as there, and no card is"
expect 0 'no sound card is there: plug one in' "$FULCRUM" devices
expect_each 0 '^sound +fair +Nothing can vibrate by sound: no sound card is there' 'plug one in' -- "$FULCRUM" doctor
expect 0 'sound +device +left, right on audio' "$FULCRUM" explain sweep --device mouse+audio

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
