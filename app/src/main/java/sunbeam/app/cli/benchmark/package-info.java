/** Command {@code benchmark}: error and time of every method, relative to the thesis's shader in the same run. */
package sunbeam.app.cli.benchmark;
