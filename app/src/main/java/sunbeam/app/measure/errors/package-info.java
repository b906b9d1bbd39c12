/** How wrong a result is, stated against the exact reference. */
package sunbeam.app.measure.errors;
