/** Linear pictures, their automatic exposure and conversion to sRGB, and comparison of pictures. */
package sunbeam.app.picture;
