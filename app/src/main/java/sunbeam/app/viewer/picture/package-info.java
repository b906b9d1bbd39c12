/** What is painted: the picture, the line between two methods, the BRDF map. */
package sunbeam.app.viewer.picture;
