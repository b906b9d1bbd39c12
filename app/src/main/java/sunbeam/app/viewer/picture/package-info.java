/** Painted components: picture, split view, BRDF map. */
package sunbeam.app.viewer.picture;
