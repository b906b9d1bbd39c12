/** Picked points: frames, angles, colors and spectra. */
package sunbeam.app.viewer.pick;
