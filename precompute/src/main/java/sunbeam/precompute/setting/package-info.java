/** Settings of a user, each declared once; command lines, scene files, metadata and controls derive from that; JSON files with the line of each value. */
package sunbeam.precompute.setting;
