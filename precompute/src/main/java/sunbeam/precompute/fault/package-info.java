/** What is wrong with a scan as it was measured, by robust statistics of its rows. Knows nothing of files. */
package sunbeam.precompute.fault;
