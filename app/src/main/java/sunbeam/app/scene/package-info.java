/** Scenes: what they hold, their files, and the session that draws one. */
package sunbeam.app.scene;
