/** Heights as text: numbers, facts from headers, and points on a grid. */
package sunbeam.precompute.scan.text;
