/** Settings of a user, each declared once; command lines, scene files, metadata and controls derive from that. */
package sunbeam.precompute.setting;
