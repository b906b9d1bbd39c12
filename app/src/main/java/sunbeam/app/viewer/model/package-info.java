/** The scene that the user sees and changes, its history, and work off the event thread. */
package sunbeam.app.viewer.model;
