/** The window with all its parts, and what they tell each other. */
package sunbeam.app.viewer.window;
