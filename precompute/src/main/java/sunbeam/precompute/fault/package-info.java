/** Detection of a scan's faults by robust statistics of its rows. Independent of file formats. */
package sunbeam.precompute.fault;
