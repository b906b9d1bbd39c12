/** Descriptions of scenes and their files. */
package sunbeam.app.scene;
