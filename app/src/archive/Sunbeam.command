#!/bin/sh
# Opens Sunbeam's viewer on macOS, by a double click.
exec "$(dirname "$0")/sunbeam" view
