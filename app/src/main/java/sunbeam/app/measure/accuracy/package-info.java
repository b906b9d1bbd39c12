/** How wrong Sunbeam is: errors against the exact reference, measured, certified and plotted. */
package sunbeam.app.measure.accuracy;
