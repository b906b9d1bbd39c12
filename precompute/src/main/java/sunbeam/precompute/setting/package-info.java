/**
 * Settings of a user: each setting is declared once, with key, unit, limits and help. Command lines, scene files, metadata and controls
 * derive from that; how each of them calls a setting is their own affair (see {@link sunbeam.precompute.setting.Origin}).
 */
package sunbeam.precompute.setting;
