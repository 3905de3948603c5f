# Sourced by the commands beside it: leaves the repository's root as the working directory and the
# packages of packages.txt installed, or says what is missing and stops. `sections` names the sections of
# that file that are wanted, `later` those that the command asks for afterwards; unset, all are wanted.

set -eu
cd "$(dirname "$0")/.."

# Those of the packages that are not installed, each after a space.
missing_of() {
    for package in "$@"; do
        case $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) in
            installed) ;;
            *) printf ' %s' "$package" ;;
        esac
    done
}

# prepare_packages <package>...
prepare_packages() {
    missing=$(missing_of "$@")
    [ -n "$missing" ] || return 0
    as_root=
    if [ "$(id -u)" != 0 ]; then as_root=$(command -v sudo || echo none); fi
    if [ "$as_root" = none ] || ! command -v apt-get >/dev/null; then
        echo "These Debian packages are missing, and installing them needs apt-get and root:" >&2
        # shellcheck disable=SC2046,SC2086 # lists of words
        echo "    apt-get install --no-install-recommends$missing${later:+$(missing_of $(packages_of $later))}" >&2
        exit 3
    fi
    echo "installing:$missing"
    mkdir -p build
    rm -f build/installed
    # shellcheck disable=SC2086 # a list of packages
    { ${are_lists_new:+:} $as_root apt-get -qq update &&
          $as_root env DEBIAN_FRONTEND=noninteractive \
              apt-get -qq -y --no-install-recommends -o APT::Status-Fd=3 install $missing \
              3>&1 >/dev/null && : >build/installed; } | show_packages
    if [ ! -e build/installed ]; then
        echo "apt-get could not install them. By hand:" >&2
        echo "    apt-get update && apt-get install --no-install-recommends$missing" >&2
        exit 3
    fi
    are_lists_new=yes
}

# Reads apt-get's status lines, "pmstatus:libfmt-dev:42.5:Unpacking ...", and shows how far it is: on a
# terminal in one line, else every fourth part.
show_packages() {
    shown=0
    while IFS=: read -r kind _ percent words; do
        case $kind in dlstatus | pmstatus) ;; *) continue ;; esac
        part=${percent%%.*}
        if [ -t 1 ]; then
            printf '\r  %3s %% %-64.64s' "$part" "$words"
        elif [ "$kind" = pmstatus ] && [ "$((part / 25))" -gt "$shown" ]; then
            shown=$((part / 25))
            echo "  $part %"
        fi
    done
    [ ! -t 1 ] || echo
}

# install_behind <section>...: installs their packages, one section after the other, while the commands that
# follow run; wait_for_packages <section> ends when they are there. Where root's password would be asked for
# again, they are installed first. The shell does not end before apt-get does, which would go on without it.
install_behind() {
    mkdir -p build
    behind=
    for section in "$@"; do rm -f "build/packages.$section"; done
    if [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; then
        install_sections "$@" >build/packages.log 2>&1 &
        behind=$!
        trap 'exit 130' INT TERM
        trap 'wait "$behind" || true' EXIT
    else
        install_sections "$@"
    fi
}
install_sections() {
    for section in "$@"; do
        # shellcheck disable=SC2046 # a list of packages
        prepare_packages $(packages_of "$section")
        : >"build/packages.$section"
    done
}
wait_for_packages() {
    [ -e "build/packages.$1" ] || echo "waiting for packages (log in build/packages.log)"
    while [ ! -e "build/packages.$1" ] && kill -0 "$behind" 2>/dev/null; do sleep 0.2; done
    if [ ! -e "build/packages.$1" ]; then
        cat build/packages.log >&2
        exit 3
    fi
}

# prepare_check <check>: its packages of check-packages.txt.
prepare_check() {
    prepare_packages $(sed -n "s/^$1 //p" tools/check-packages.txt)
}

# Reads what ninja says and shows how far it is, and which folder is compiled: on a terminal in one line, else
# every tenth part.
show_steps() {
    shown=0 of=0
    while IFS= read -r line; do
        case $line in "["[0-9]*/[0-9]*"]"*) ;; *) continue ;; esac
        step=${line#"["}
        total=${step#*/} step=${step%%/*}
        total=${total%%"]"*}
        what=${line##*" object "} # "[3/24] Building CXX object src/base/CMakeFiles/..."
        [ "$what" != "$line" ] || what=${line#*"] "}
        what=${what%%/CMakeFiles*}
        [ "$total" = "$of" ] || { shown=0 of=$total; }
        if [ -t 1 ]; then
            printf '\r  step %s of %s  %-48.48s' "$step" "$total" "$what"
        elif [ $((10 * step / total)) -gt $shown ]; then
            shown=$((10 * step / total))
            echo "  step $step of $total  $what"
        fi
    done
    [ ! -t 1 ] || [ "$of" = 0 ] || echo
}

# build_in <preset> <targets> <cmake options>: configures and builds build/<preset>, showing how far it is,
# and the log (build/build.log) only on failure. No targets: all.
build_in() {
    preset=$1 targets=$2
    shift 2
    mkdir -p build
    echo "building (build/$preset, log in build/build.log)"
    rm -f build/built
    # shellcheck disable=SC2086 # a list of targets
    { cmake --preset "$preset" "$@" && cmake --build --preset "$preset" ${targets:+--target $targets} &&
        : >build/built; } 2>&1 | tee build/build.log | show_steps
    if [ ! -e build/built ]; then
        cat build/build.log >&2
        exit 3
    fi
}

# build <cmake options>: all of build/release.
build() { build_in release "" "$@"; }

# packages_of <section>...: their packages; without a section, all.
packages_of() {
    awk -v wanted=" $* " '
        /^# [a-z]+:/ { section = substr($2, 1, length($2) - 1) }
        !/^#/ && (wanted ~ /^ *$/ || index(wanted, " " section " ")) { print }' tools/packages.txt
}

# shellcheck disable=SC2046,SC2086 # lists of words
prepare_packages $(packages_of ${sections:-})
