/** Computations that run in the background. */
package sunbeam.app.work;
