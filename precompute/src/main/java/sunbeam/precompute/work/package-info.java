/** Progress and cancellation of long computations. */
package sunbeam.precompute.work;
