/** Controls beside the picture. */
package sunbeam.app.viewer.panel;
