/** Picked points of the skin: their frames, angles, colors and spectra. */
package sunbeam.app.viewer.pick;
