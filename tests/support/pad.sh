# An Xbox pad that stand_in_pad plays, after display.sh. `"$PAD" "$pad" PROGRAM` has it.
[ -x "${PAD:-}" ] || { echo "skipped: no umockdev (Debian packages umockdev and libumockdev-dev)"; exit 77; }
pad=$work/pad
mkfifo "$pad"
exec {pad_says}<>"$pad" # held open, so that a line waits for the pad, not the test
say() { echo "$*" >&"$pad_says"; } # NAME VALUE...: one report
tap() { # BUTTON...: pressed and let go; each is seen by a frame of the program
  for button in "$@"; do
    case $button in
    left) say cross_x -1 && say cross_x 0 ;;
    right) say cross_x 1 && say cross_x 0 ;;
    up) say cross_y -1 && say cross_y 0 ;;
    down) say cross_y 1 && say cross_y 0 ;;
    *) say "$button" 1 && say "$button" 0 ;;
    esac
  done
}
