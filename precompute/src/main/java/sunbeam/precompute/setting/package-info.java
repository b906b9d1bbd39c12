/**
 * Settings of a user: each setting is declared once, with key, unit, limits and help. Command lines, scene files, metadata and controls
 * derive from that. Each names a setting in its own way (see {@link sunbeam.precompute.setting.Choices.Origin}).
 */
package sunbeam.precompute.setting;
