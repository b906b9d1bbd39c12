/**
 * Shader text before a driver sees it: libraries of named files, include expansion with the origin of every line, the
 * prologue of defines, and the reading of compilers' logs. Plain string code that needs no graphics.
 */
package jrtr.glsl;
