/** Plots as PNG, by JFreeChart. */
package sunbeam.app.files.plot;
