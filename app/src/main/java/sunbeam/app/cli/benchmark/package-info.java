/** Error and time of every method in one run, beside the thesis's shader. */
package sunbeam.app.cli.benchmark;
