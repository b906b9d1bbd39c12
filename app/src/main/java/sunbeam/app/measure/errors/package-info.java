/** Measurement of the errors of pictures and tables against the exact reference. */
package sunbeam.app.measure.errors;
