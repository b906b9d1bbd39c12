/**
 * What is wrong with a scan as it was measured: rows that the instrument did not measure, heights beyond its range, rows that
 * jump. The one place where such faults are found; it knows heights and nothing of files, options and light.
 */
package sunbeam.precompute.fault;
