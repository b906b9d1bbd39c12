/**
 * Preparation of shader text for the driver: libraries of named files, include expansion with the origin of every line, the
 * prologue of defines, parsing of compiler logs. Plain string code that needs no graphics.
 */
package jrtr.glsl;
