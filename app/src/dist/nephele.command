#!/bin/sh
# Starts Nephele on macOS by a double click, in a window of Terminal.
cd "$(dirname "$0")" && exec sh ./nephele "$@"
