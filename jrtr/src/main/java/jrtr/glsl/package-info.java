/** Preparation of shader text for the driver: libraries, include expansion with the origin of every line, defines. Needs no graphics. */
package jrtr.glsl;
