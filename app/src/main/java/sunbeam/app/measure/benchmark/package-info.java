/** Error and time of every method in one run, beside the thesis's shader, and how cost grows. */
package sunbeam.app.measure.benchmark;
