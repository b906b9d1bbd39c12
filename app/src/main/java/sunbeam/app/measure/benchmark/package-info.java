/** Time per frame, always beside the thesis's shader in the same run. */
package sunbeam.app.measure.benchmark;
