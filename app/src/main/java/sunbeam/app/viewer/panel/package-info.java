/** Controls beside the picture, each of a setting. */
package sunbeam.app.viewer.panel;
