# The start page from outside, after display.sh: where its focus is, and what was started from it.

# start_fulcrum [BEFORE...]: `fulcrum` without arguments, begun by what comes before it.
start_fulcrum() {
  "$@" "$FULCRUM" >"$work/said" 2>&1 &
  program=$!
  window=
  until_seen find_window
  [ -n "$window" ] || { cat "$work/said"; echo "FAILED: no window"; exit 1; }
  xdotool windowactivate --sync "$window"
}

# unhurried SCENE: with time for a busy machine.
unhurried() {
  mkdir -p "$work/content/scenarios"
  cp -rL "$(dirname "$FULCRUM")/content/scenarios/$1" "$work/content/scenarios/"
  sed -i -E 's/^time_limit: .*/time_limit: 300/' "$work/content/scenarios/$1/scenario.yaml"
  export FULCRUM_CONTENT=$work/content
}

# accent WxH+X+Y: what is in focus is surrounded there.
blue=84,164,255
accent() {
  shot part
  [ "$(convert "$work/part.png" -crop "$1" +repage -fuzz 8% -fill black +opaque "rgb($blue)" -format '%[fx:maxima > 0.3]' info:)" = 1 ]
}
# focused ROW: of the column of scenarios, or of the settings.
scenario_focused() { accent "20x40+20+$((83 + 40 * $1))"; }
setting_focused() { accent "20x34+355+$((517 + 34 * $1))"; }
key() { xdotool key --window "$window" "$@"; }

mapfile -t scenes < <("$FULCRUM" list | awk '{ print $1 }')
place() { for i in "${!scenes[@]}"; do [ "${scenes[$i]}" != "$1" ] || echo "$i"; done; }

# The newest run's folder, which is named after its scenario.
newest() { find "$XDG_DATA_HOME/fulcrum/runs" -maxdepth 1 -name "$1-*" 2>/dev/null | LC_ALL=C sort | tail -n 1; }
began() { [ -n "$(newest "$1")" ]; }
# another SCENARIO FOLDER: a newer run than that one.
another() { [ "$(newest "$1")" != "$2" ]; }
trials() { [ "$("$FULCRUM" results --participant "$1" 2>/dev/null | grep -c " $2 ")" = "$3" ]; }

# A picture of the window, kept where FULCRUM_PICTURES says.
picture() {
  shot "$1"
  [ -z "${FULCRUM_PICTURES-}" ] || cp "$work/$1.png" "$FULCRUM_PICTURES/"
}
# A dark card in the middle: what came of the trial, or the list of keys.
dark() { [ "$(convert "$1" -crop "$2" +repage -scale 1x1 -format '%[fx:r < 0.2 && g < 0.2]' info:)" = 1 ]; }
card_is_there() { shot card && dark "$work/card.png" 360x180+460+270; }
no_card_is_there() { ! card_is_there; }
shows_keys() { card_is_there; }
shows_no_keys() { no_card_is_there; }
