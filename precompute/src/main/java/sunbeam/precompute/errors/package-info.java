/** Differences between computed and exact colors, and statistics of them. */
package sunbeam.precompute.errors;
