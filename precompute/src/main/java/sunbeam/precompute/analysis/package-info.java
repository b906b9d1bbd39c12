/** What a height map shows before any light meets it: statistics of heights and slopes, power spectrum, periods. */
package sunbeam.precompute.analysis;
