/**
 * Settings of a user, each declared once, with key, unit, limits and help; command lines, scene files, metadata and controls derive from
 * that.
 */
package sunbeam.precompute.setting;
