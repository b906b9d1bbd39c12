/** Speed against error: every method's, and how cost grows with pixels, samples, relief and coherence length. */
package sunbeam.app.measure.performance;
