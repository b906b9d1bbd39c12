/** Heights as text: the numbers, what headers say of them, and points on a grid. */
package sunbeam.precompute.scan.text;
